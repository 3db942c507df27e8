#pragma once

#include <string>

#include "scan/scan.h"

namespace regarment {

/// What a person said about a file. "auto" lets the shape decide.
struct ScanOptions {
  std::string units = "auto";  // "auto", "mm", "cm", "m", "inch": the unit of the file's numbers
  std::string up = "auto";     // "auto" or a signed file axis, "+x" ... "-z": where the head is
  std::string front = "auto";  // the same: where the person faces; perpendicular to `up`

  // Scans of more vertices are worked on through a thinner copy (Scan::thin) of half as many.
  // Larger sees finer edges, where the scanner did, and costs time.
  std::size_t most_vertices = 400'000;

  /// Throws UsageError naming the option, its value and what it may be.
  void check() const;
};

/// Turns a file's mesh or point cloud into a Scan: finds unit, up axis, front and floor, marks
/// outliers, estimates noise, and gives every vertex an outward unit normal.
///
/// What is found does not depend on the order of vertices, nor on how the file's frame is turned by
/// quarter turns, turned about the vertical, shifted, or scaled to another unit. A person may
/// stand, walk or stretch their arms; feet or head may be missing (then `facts.warnings` says so).
/// Triangles that repeat another are dropped. A mirrored file stays mirrored. Where `options.up` or
/// `options.front` is given that axis is taken exactly.
///
/// `facts.file` and `facts.sha256` stay empty: the caller knows the file. Vertices with a
/// non-finite coordinate are moved to the origin of the body frame, marked as outliers and said in
/// a warning.
///
/// Throws UsageError for options that contradict themselves, and NoPersonError with a reason and
/// advice when the shape is no person or its unit cannot be told.
Scan make_scan(Mesh mesh_in_file_frame, const ScanOptions& options = {});

}  // namespace regarment
