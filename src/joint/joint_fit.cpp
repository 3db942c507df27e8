#include "joint/joint_fit.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "garment/hold_dimensions.h"
#include "garment/particles.h"
#include "joint/joint_system.h"
#include "joint/refine.h"
#include "joint/worn_lines.h"

namespace regarment {
namespace {

constexpr double kStill = 2e-5;        // m, a step this short ends a level
constexpr double kFirstSpread = 0.03;  // m, StepLimits of the first round; doubles each round
constexpr double kLastSpread = 0.5;    // m

Dimensions moved_by(const JointModel& model, const Eigen::VectorXd& step, const Dimensions& fixed) {
  Dimensions moved = model.dimensions();
  Eigen::Index k = 0;
  for (const Dimension& d : model.garment().dimensions()) moved[d.name] += step[k++];
  return nearest_holding(model.garment(), moved, fixed);
}

void judge(const JointModel& model, const JointTarget& target, const std::vector<Vec3>& x,
           JointFit& out) {
  double sum = 0, weight = 0, all = 0, on = 0;
  const JointScales& scales = model.scales();
  const double full = 1 / scales.patch / (scales.surface * scales.surface);
  for (const double a : target.areas) all += a;
  for (const SurfaceMatch& m : model.surface) {
    Vec3 at = -m.point;
    for (int c = 0; c < 3; ++c) at += m.share[c] * x[m.particles[c]];
    const double off = m.normal.dot(at);
    sum += m.weight * off * off, weight += m.weight;
    on += m.weight / full;
  }
  out.surface_error = weight > 0 ? std::sqrt(sum / weight) : 0;
  out.matched = all > 0 ? on / all : 0;
}

}  // namespace

void JointOptions::check() const {
  if (levels.empty()) throw InvalidInput("JointOptions: at least one level is needed");
  for (const JointLevel& level : levels) {
    if (!(level.edge_length >= 0.005 && level.edge_length <= 0.2))
      throw InvalidInput("JointOptions: edge_length must lie between 0.005 and 0.2 m");
    if (level.rounds < 1 || level.rounds > 1000)
      throw InvalidInput("JointOptions: rounds must lie between 1 and 1000");
    if (!(level.robust > 0)) throw InvalidInput("JointOptions: robust must be positive");
  }
}

JointFit joint_fit(const GarmentTemplate& garment, const Dimensions& start, const Pattern& pattern,
                   const std::vector<Vec3>& placed, const JointTarget& target,
                   const std::vector<MeasuredLength>& lengths, const JointOptions& options,
                   const Progress& progress) {
  options.check();
  if (placed.size() != pattern.flat.size())
    throw InvalidInput("joint_fit: one position per pattern vertex");
  std::vector<bool> held;
  for (const Dimension& d : garment.dimensions())
    held.push_back(options.fixed.find(d.name) != options.fixed.end());
  Pattern last = pattern;
  std::vector<Vec3> x = particle_positions(pattern, placed);
  Dimensions at = start;
  std::vector<ClosestPoint> outer;
  for (const OuterGarment& over : target.outer) outer.emplace_back(over.particles, over.triangles);
  JointFit out;
  for (std::size_t l = 0; l < options.levels.size(); ++l) {
    const JointLevel& level = options.levels[l];
    JointModel model(garment, at, level.edge_length, options.scales);
    move_pattern(garment, at, last);
    x = refine(last, x, model.pattern());
    JointSystem system(model);
    StepLimits limits;
    MatchOptions match = options.match;
    match.robust = level.robust;
    limits.position_spread = limits.dimension_spread = kFirstSpread;
    for (int round = 0; round < level.rounds; ++round) {
      progress.report("fit", (static_cast<double>(l) + static_cast<double>(round) / level.rounds) /
                                 static_cast<double>(options.levels.size()));
      match_scan(target, x, match, model);
      if (!outer.empty()) bound_inside(outer, x, coverage(model), options.inside, model);
      model.lengths = length_evidence(garment, model.dimensions(), lengths);
      const JointStep step = system.step(model, x, held, limits);
      double longest = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] += step.positions[i];
        longest = std::max(longest, step.positions[i].norm());
      }
      model.move_to(moved_by(model, step.dimensions, options.fixed));
      if (!step.shortened)
        limits.position_spread = limits.dimension_spread =
            std::min(kLastSpread, 2 * limits.position_spread);
      if (longest < kStill) break;
    }
    at = model.dimensions();
    last = model.pattern();
    if (l + 1 < options.levels.size()) continue;
    match_scan(target, x, match, model);
    model.lengths = length_evidence(garment, at, lengths);
    judge(model, target, x, out);
  }
  out.dimensions = at;
  for (std::size_t v = 0; v < last.flat.size(); ++v) out.draped.push_back(x[last.particle[v]]);
  out.pattern = std::move(last);
  out.worn = worn_lines(garment, at, out.pattern, out.draped);
  return out;
}

}  // namespace regarment
