#pragma once

#include <vector>

#include "measure/garment_edges.h"
#include "measure/outline.h"

namespace regarment {

/// The girth of worn cloth along a line that lies level on the flat garment.
struct LevelGirth {
  double t = 0;        // m over the cloth from the edge the levels are counted from
  double girth = 0;    // m
  double bridged = 0;  // share of it that runs over gaps without data
};

/// Lines round the trunk that lie level on the flat garment. Worn, they wave as the garment's edges
/// do: where an edge hangs lower, so do the lines beside it. Every column of the trunk's map has
/// its own way over the cloth from the edge; where the opposite edge is given as well, ways are
/// scaled so that both edges lie level. Borrows `view`.
class ClothLevels {
 public:
  /// Levels counted from `edge` into the garment. `opposite` may be null: the ways are then as long
  /// as they are, up to `most` (m). `length`: m, distance of the two edges over the cloth; 0: the
  /// mean way.
  ClothLevels(const LimbView& view, const GarmentEdge& edge, const GarmentEdge* opposite,
              double length, double most);

  double length() const { return length_; }  // m, from edge to edge, or as far as levels go

  /// Level of a point of the cloth, m; below 0 or beyond `length` outside.
  double level(const Vec3& p) const;

  /// Height of a level above the floor in the direction `phi` of the trunk, m.
  double height(double t, double phi) const;

 private:
  double at_column(int column, double s) const;
  double height_at_column(int column, double t) const;

  const LimbView& view_;
  double sign_;                            // +1: the garment lies at larger s than the edge
  double length_ = 0;                      // m
  std::vector<double> start_;              // m, height of the edge, per column
  std::vector<double> rise_;               // m of height between a way's entries, per column
  std::vector<std::vector<double>> ways_;  // m over the cloth from the edge, per column
};

/// Girths of the samples `cloth` (indices) at levels every `step` metres from `from` to `to`, each
/// from a slice that reaches `half` metres up and down. Levels without an outline are left out.
/// `reach`: as for trace_outline.
std::vector<LevelGirth> level_girths(const SurfaceSamples& samples, const std::vector<int>& cloth,
                                     const LimbView& view, const ClothLevels& levels, double from,
                                     double to, double step, double half, double reach);

}  // namespace regarment
