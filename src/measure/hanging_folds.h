#pragma once

#include <vector>

#include "placement/limb_map.h"

namespace regarment {

struct GarmentEdge;

/// Folds of a wide hem that stand out from the trunk and hang lower than the hem between them, as
/// those at the side seams of flared skirts do. A height per column, which an edge has, cannot say
/// how low such a fold reaches: that also depends on the distance from the axis. Empty: none.
struct HangingFolds {
  static constexpr double kStep = 0.01;  // m, cells of distance from the axis
  int cells = 0;                         // per column
  std::vector<double> lowest;            // columns * cells, m; NaN: no fold there

  bool empty() const { return lowest.empty(); }
  /// Height down to which a fold is seen in this column, `r` from the axis, m; NaN: no fold there.
  double at(int column, double r) const;
};

/// Looks for folds that hang from the hem `edge` of a garment round the trunk: surface joined to
/// the cloth above the hem that stands out further than the hem does on both sides of it. `taken`:
/// one per sample, or empty. `top`: m above the floor, folds lie lower. Legs under a hem stand out
/// less; arms beside it may not, so this is for garments that end below the hands' reach.
HangingFolds find_hanging_folds(const SurfaceSamples& samples, const Body& body,
                                const LimbView& torso, const GarmentEdge& edge,
                                const std::vector<std::uint8_t>& taken, double top);

/// The edge in space, closed: one point per column, and out and back along each fold that hangs.
std::vector<Vec3> edge_curve(const GarmentEdge& edge, const LimbView& view);

}  // namespace regarment
