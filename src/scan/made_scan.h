#pragma once

#include <vector>

#include "scan/body_pieces.h"
#include "scan/make_scan.h"
#include "scan/outer_sheet.h"
#include "scan/weld.h"

namespace regarment {

/// A scan and what make_scan has yet to say about it.
struct MadeScan {
  Scan scan;                       // findings: how it stands, and its normals
  std::vector<Belongs> belongs;    // per vertex
  std::vector<OuterSheet> sheets;  // frame of the file
};

/// make_scan at the vertices the file has. `welded` are the mesh's.
MadeScan make_scan_itself(Mesh mesh_in_file_frame, Welded welded, const ScanOptions& options);

/// make_scan of a mesh with very many vertices: all is found out on a thinner copy, which
/// `scan.thin` keeps; each vertex takes normal and outlier mark of the thin one that stands for it.
MadeScan make_scan_by_thinning(Mesh mesh_in_file_frame, const ScanOptions& options);

}  // namespace regarment
