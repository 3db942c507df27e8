#pragma once

#include <cstdint>
#include <vector>

#include "synthetic/reconstruct_trim.h"
#include "synthetic/scanner.h"

namespace regarment {

/// How points become a surface.
struct ReconstructOptions {
  double cell = 0.006;  // m, 0.002 .. 0.05: length of the triangles' edges, about
  // m, 0.001 .. 0.2: surface further than this from every point is invented: label 255. Right
  // for points 3 mm apart, as `open_reach` is; both should grow with the distance between points.
  double invented = 0.008;
  double open_reach = 0.005;  // m, 0.001 .. 0.2: an open mesh goes so far beyond the points
  int least_piece = 200;      // 0 .. 1e6: separate pieces of fewer triangles are left out
  std::vector<FlatCut> cuts;  // of an open mesh

  void check() const;  // throws InvalidInput naming the field and its value
};

/// A surface made from a scan, and the truth of each vertex.
struct SurfacedPerson {
  Mesh mesh;                         // body frame, m; colours when the points have them
  std::vector<std::uint8_t> labels;  // one per vertex: 0 person, i = i-th garment, 255 not scored
};

/// The closed surface through the points of a scan with their normals: caps under hems and over
/// holes included (reconstruct_field.h). A vertex has the label that most of the eight nearest
/// points within `invented` have, of equally many the least; 255 when there is none. Colours are
/// the mean of the nearest points'. About a second for 200,000 points. The same bytes for the same
/// input. Throws InvalidInput when options are out of range or there are no points.
SurfacedPerson reconstruct_closed(const ScannedPerson& scan, const ReconstructOptions& options);

/// The same surface without the triangles that have a vertex further than `open_reach` from every
/// point, and without what `cuts` take away: it ends where the data ends.
SurfacedPerson reconstruct_open(const ScannedPerson& scan, const ReconstructOptions& options);

}  // namespace regarment
