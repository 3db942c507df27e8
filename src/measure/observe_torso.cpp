#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/median.h"
#include "measure/level_fit.h"
#include "measure/observer.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGirthShare = 0.006, kLeastDeviation = 0.003;  // of a girth, and m
// Of what was added for folds not seen into, and of what runs over gaps.
constexpr double kMissedShare = 0.4, kBridgedShare = 0.3;
constexpr double kHanging = 1.05;       // times what levels tell: folds that hang add cloth
constexpr double kHangingShare = 0.05;  // of an edge along folds that hang
constexpr double kLevelStep = 0.01;     // m between levels
constexpr double kFirstLevel = 0.01;    // m, nearer to an edge a scan rounds it off
constexpr double kEdgeWindow = 0.07;    // m, levels that tell the girth at an edge
constexpr double kLevelWindow = 0.06;   // m, those that tell the girth at a level, on both sides
constexpr double kBelowArmpit = 0.02;   // m, where the trunk's own cloth begins
constexpr double kChestReach = 0.06;    // m further down, levels that tell the girth of the chest

double deviation_of(const FittedGirth& fit) {
  return std::hypot(kGirthShare * fit.value + kLeastDeviation, fit.spread,
                    kMissedShare * fit.unseen + kBridgedShare * fit.bridged * fit.value);
}

/// How long a slanting side is whose cloth grows by this much round the limb.
double side_of(double height, double growth) { return std::hypot(height, growth / 4); }

/// Where the garment is cut at an angle, `offset` below its upper edge along the middle: a level of
/// `trunk`. Levels divide each way over the cloth in the same proportion; ways along slanting sides
/// are longer, and the girth along a level is the flat girth at the height where it ends at the
/// sides.
double cut_level(const TrunkLevels& trunk, double offset) {
  double level = offset;
  const FittedGirth top = girth_at_level(trunk.girths, 0, kEdgeWindow);
  const FittedGirth end = girth_at_level(trunk.girths, trunk.length, kEdgeWindow);
  const double rest = trunk.length - offset;
  for (int round = 0; round < 2 && top.found && end.found && rest > 0; ++round) {
    const FittedGirth cut = girth_at_level(trunk.girths, level, kLevelWindow);
    if (!cut.found) break;
    const double first = side_of(offset, cut.value - top.value);
    level = trunk.length * first / (first + side_of(rest, end.value - cut.value));
  }
  return level;
}

/// The level at which a garment that has this edge is cut at an angle; 0 for none.
double cut_of(const GarmentTemplate& garment, const TrunkLevels& trunk) {
  for (const Observation& o : garment.observations())
    if (o.kind == Observation::Kind::GirthAtOffset && o.side.empty() && o.edge == trunk.upper &&
        o.offset < trunk.length)
      return cut_level(trunk, o.offset);
  return 0;
}

}  // namespace

double Observer::trunk_top() const {
  double top = body.neck;
  for (const double armpit : body.armpit)
    if (armpit > 0) top = std::min(top, armpit);
  return top - kBelowArmpit;
}

std::optional<TrunkLevels> Observer::trunk_levels() const {
  TrunkLevels out;
  for (const auto& [name, e] : edges.edges)
    if (e.limb == "torso" && !e.covered) (e.garment_above ? out.lower : out.upper) = name;
  if (out.upper.empty() || out.lower.empty()) return std::nullopt;
  const GarmentEdge &top = *edge(out.upper), &bottom = *edge(out.lower);
  double sum = 0, n = 0;
  for (const double way : {centre_path(top, bottom, 0.0), centre_path(top, bottom, kPi)})
    if (std::isfinite(way)) sum += way, n += 1;
  const LimbView& view = limb(top);
  const ClothLevels levels(view, top, &bottom, n > 0 ? sum / n : 0, 0);
  out.length = levels.length();
  out.girths = level_girths(samples, on_cloth(view.members), view, levels, kFirstLevel,
                            out.length - kFirstLevel, kLevelStep, half_slice(), reach());
  return out;
}

/// The girth at an edge, from levels inside.
ObservedLength Observer::torso_girth(const Observation& o, const GarmentEdge& e) const {
  FittedGirth fit;
  if (trunk) {
    const double at = e.garment_above ? trunk->length : 0;
    const double cut = cut_of(garment, *trunk);
    if (e.garment_above && cut > 0 && trunk->length - cut > kEdgeWindow) {
      const FittedGirth at_cut = girth_at_level(trunk->girths, cut, kLevelWindow);
      if (at_cut.found) fit = girth_of_straight_piece(trunk->girths, cut, at_cut.value, at);
    }
    if (!fit.found) fit = girth_at_level(trunk->girths, at, kEdgeWindow);
  } else {
    const LimbView& view = limb(e);
    const ClothLevels levels(view, e, nullptr, 0, kEdgeWindow);
    fit = girth_at_level(level_girths(samples, on_cloth(view.members), view, levels, kFirstLevel,
                                      kEdgeWindow, kLevelStep, half_slice(), reach()),
                         0, kEdgeWindow);
  }
  if (!fit.found) return {&o, 0, 0, false};
  const double unseen_edge = 0.05 * (1 - e.found.coverage) * fit.value;
  double value = fit.value, deviation = deviation_of(fit) + unseen_edge;
  // Levels do not follow folds that hang lower than the hem beside them; the edge itself does.
  const double along = e.folds.empty() ? 0 : closed_length(edge_curve(e, limb(e)));
  const bool hanging = along > kHanging * value;
  if (hanging) value = along, deviation = std::hypot(deviation, kHangingShare * value);
  return {&o, value, deviation, true, hanging};
}

/// The girth at a level of the flat garment, counted from `e`.
ObservedLength Observer::level_girth(const Observation& o, const GarmentEdge& e) const {
  FittedGirth fit;
  if (trunk && !e.garment_above) {
    fit = girth_at_level(trunk->girths, cut_level(*trunk, o.offset), kLevelWindow);
  } else {
    const LimbView& view = limb(e);
    const ClothLevels levels(view, e, nullptr, 0, o.offset + kLevelWindow);
    fit = girth_at_level(level_girths(samples, on_cloth(view.members), view, levels, kFirstLevel,
                                      o.offset + kLevelWindow, kLevelStep, half_slice(), reach()),
                         o.offset, kLevelWindow);
  }
  if (!fit.found) return {&o, 0, 0, false};
  return {&o, fit.value, deviation_of(fit), true};
}

/// The girth of a garment with sleeves below the arms: the same all the way down on the flat
/// garment.
ObservedLength Observer::chest_girth(const Observation& o, const GarmentEdge& e) const {
  if (body.armpit[0] <= 0 && body.armpit[1] <= 0) return {&o, 0, 0, false};
  const LimbView& view = limb(e);
  const std::vector<int> on = on_cloth(view.members);
  std::vector<double> lengths;
  double bridged = 0;
  for (double y = trunk_top() - o.offset; y > trunk_top() - o.offset - kChestReach;
       y -= kLevelStep) {
    const Vec3 centre = view.axis.point({y, 0, 0});
    std::vector<Vec2> points;
    for (const int m : on) {
      const Vec3 d = samples.positions[m] - centre;
      if (std::abs(d.y()) < half_slice()) points.emplace_back(d.z(), d.x());
    }
    const Outline outline = trace_outline(points, Vec2::Zero(), reach());
    if (outline.points.empty() || outline.bridged > 0.4) continue;
    lengths.push_back(outline.length()), bridged += outline.bridged;
  }
  if (lengths.size() < 2) return {&o, 0, 0, false};
  const double value = median(lengths), share = bridged / static_cast<double>(lengths.size());
  return {&o, value, (0.007 + kBridgedShare * share) * value + kLeastDeviation, true};
}

}  // namespace regarment
