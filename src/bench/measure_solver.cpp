#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "bench/measures.h"
#include "bench/step_system.h"
#include "garment/find_template.h"

namespace regarment {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kShown = 3000;    // particles that the yardstick is solved for
constexpr double kTimesEigen = 3;  // what is aimed at

}  // namespace

void measure_solver(Bench& bench) {
  const GarmentTemplate skirt = find_template("skirt");
  GrowthCurve growth{"a step of the joint fit", "particles", {}, 0};
  bool compared = false;
  for (const double edge : {0.05, 0.035, 0.025, 0.0175, 0.0115, 0.008, 0.0058}) {
    const JointModel model(skirt, skirt.typical(), edge, JointScales{});
    const int n = model.pattern().particle_count;
    const StepSystem p = step_system(model);
    BlockFactor ours(p.blocks);
    const int rounds = std::clamp(20'000 / n, 1, 10);
    std::vector<std::function<void()>> actions = {
        [&] { ours.factorize(p.blocks), ours.solve(p.right); }};
    Eigen::SimplicialLDLT<Sparse> scalar;
    const bool compares = !compared && n >= kShown;
    if (compares) {
      scalar.analyzePattern(p.matrix);
      actions.emplace_back(
          [&] { scalar.factorize(p.matrix), Eigen::MatrixXd(scalar.solve(p.right)); });
    }
    const std::vector<double> seconds = best_in_turn(actions, rounds);
    growth.points.push_back({static_cast<double>(n), seconds[0]});
    if (!compares) continue;
    compared = true;
    bench.rows.push_back(
        {.group = "Solver",
         .name = "factor and solve a step of the joint fit, " + std::to_string(n) + " particles",
         .value = 1e3 * seconds[0],
         .unit = "ms",
         .other = "Eigen",
         .other_value = 1e3 * seconds[1],
         .at_least = kTimesEigen,
         .by_ratio = true});
  }
  growth.exponent = growth_exponent(growth.points);
  bench.curves.push_back(std::move(growth));
}

}  // namespace regarment
