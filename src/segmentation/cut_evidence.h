#pragma once

#include <map>
#include <string>
#include <vector>

#include "garment/pattern.h"
#include "measure/garment_region.h"
#include "segmentation/segment.h"

namespace regarment {

/// How sure a cut is of what it looks at.
struct CutOptions {
  // Scan this far off the draped garment is as likely cloth as not, m. Larger forgives a drape that
  // lies off the cloth, and takes in what lies close under it.
  double sheet_reach = 0.012;
  // Standard error of the garment's border where `edge_error` says nothing, m. Larger lets creases
  // and colours move the border further.
  double border_error = 0.005;
  std::map<std::string, double> edge_error;  // edge name -> standard error of its place, m
  // What a border costs per neighbour it runs between, in log-odds of one vertex. Larger makes it
  // smoother and leaves fewer islands.
  double smoothness = 1.5;
  bool colour = true;  // learn the colours of garment and person, where the scan has any

  void check() const;  // throws InvalidInput naming the field and its value
};

/// What the draped garment says of a vertex of a scan.
struct SheetPoint {
  double distance = 1;      // m, from the garment; off its plane where its border is nearest
  bool outside = false;     // it lies on the outer side of the garment
  double inside = -1;       // m from the garment's border, along it; negative beyond the border
  double agreement = 0;     // cosine between the normals of vertex and garment
  double trust = 0;         // 0..1: how well the garment lies on the scan where it is nearest
  double border_error = 0;  // m, standard error of the nearest edge
};

/// Looks from each vertex at the draped garment. Vertices marked in `skip` (one per vertex) are not
/// looked at and do not count as covered: theirs is an empty SheetPoint.
std::vector<SheetPoint> look_at_sheet(const Scan& scan, const std::vector<std::uint8_t>& skip,
                                      const Pattern& pattern, const std::vector<Vec3>& draped,
                                      const CutOptions& options);

/// Logarithm of the odds that each vertex is cloth of the garment: on it and inside its border.
/// Between -8 and 8; -8 for those in `skip`.
std::vector<float> cloth_odds(const Scan& scan, const std::vector<std::uint8_t>& skip,
                              const std::vector<BodyPart>& parts, const GarmentRegion& region,
                              const std::vector<SheetPoint>& sheet, const CutOptions& options);

}  // namespace regarment
