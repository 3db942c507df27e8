#include "joint/side_differences.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "garment/particles.h"
#include "joint/joint_system.h"
#include "joint/length_evidence.h"
#include "joint/refine.h"

namespace regarment {
namespace {

constexpr double kEdgeLength = 0.04;  // m
constexpr int kRounds = 5;
constexpr double kSpread = 0.1;  // m, standard deviation of a difference before the scan is seen

/// 1 on the left (front), -1 on the right (back), 0 in between.
double side_of(const Pattern& pattern, int vertex, double half_width, Sides sides) {
  const int panel = pattern.panel[vertex];
  const std::string& limb = pattern.panel_limbs[panel];
  const double across = std::clamp(pattern.flat[vertex].x() / half_width, -1.0, 1.0);
  if (sides == Sides::FrontBack)
    return (pattern.panel_is_front[panel] ? 1 : -1) * std::cos(std::numbers::pi / 2 * across);
  if (limb == "left_arm") return 1;
  if (limb == "right_arm") return -1;
  return across;
}

double half_width_of_trunk(const Pattern& pattern) {
  double widest = 1e-9;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    if (pattern.panel_limbs[pattern.panel[v]] == "torso")
      widest = std::max(widest, std::abs(pattern.flat[v].x()));
  return widest;
}

void pad(Eigen::VectorXd& v, Eigen::Index size) {
  const Eigen::Index before = v.size();
  v.conservativeResize(size);
  v.tail(size - before).setZero();
}

}  // namespace

std::vector<Vec2> sided_slope(const FlatSlopes& slopes, const Pattern& pattern,
                              const SidedDimension& sided) {
  const auto name = std::find(slopes.names.begin(), slopes.names.end(), sided.name);
  if (name == slopes.names.end())
    throw InvalidInput("side_differences: no dimension is called " + sided.name);
  std::vector<Vec2> out = slopes.vertex[static_cast<std::size_t>(name - slopes.names.begin())];
  const double half_width = half_width_of_trunk(pattern);
  for (std::size_t v = 0; v < out.size(); ++v)
    out[v] *= side_of(pattern, static_cast<int>(v), half_width, sided.sides) / 2;
  return out;
}

std::vector<double> side_differences(const GarmentTemplate& garment, const JointFit& fit,
                                     const JointTarget& target,
                                     const std::vector<MeasuredLength>& lengths,
                                     const std::vector<SidedDimension>& sided,
                                     const JointOptions& options) {
  JointModel model(garment, fit.dimensions, kEdgeLength, options.scales);
  const auto shared = static_cast<Eigen::Index>(model.dimension_count());
  const std::vector<LengthEvidence> evidence = length_evidence(garment, fit.dimensions, lengths);
  FlatSlopes extra;
  for (const SidedDimension& s : sided) {
    extra.names.push_back(s.name + (s.sides == Sides::LeftRight ? " left-right" : " front-back"));
    extra.vertex.push_back(sided_slope(model.flat(), model.pattern(), s));
  }
  model.add_slopes(extra, kSpread);
  const auto all = static_cast<Eigen::Index>(model.dimension_count());
  std::vector<Vec3> x =
      refine(fit.pattern, particle_positions(fit.pattern, fit.draped), model.pattern());
  std::vector<bool> held;
  for (const Dimension& d : garment.dimensions()) held.push_back(options.fixed.contains(d.name));
  held.resize(static_cast<std::size_t>(all), false);
  MatchOptions match = options.match;
  match.robust = options.levels.back().robust;
  JointSystem system(model);
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(all);
  for (int round = 0; round < kRounds; ++round) {
    match_scan(target, x, match, model);
    model.lengths = evidence;
    for (LengthEvidence& e : model.lengths) {
      pad(e.slope, all);
      e.at_model += e.slope.dot(moved);
    }
    const JointStep step = system.step(model, x, held, {});
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += step.positions[i];
    model.shift(step.dimensions);
    moved += step.dimensions;
  }
  return {moved.data() + shared, moved.data() + all};
}

}  // namespace regarment
