#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "bench/measures.h"
#include "garment/find_template.h"
#include "joint/block_factor.h"
#include "joint/joint_model.h"

namespace regarment {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kPull = 400, kAcross = 1e6;  // 1/m^2, of a step of 5 cm and of a scan to 1 mm
constexpr double kShown = 3000;               // particles that the yardstick is solved for
constexpr double kTimesEigen = 3;             // what is aimed at

/// The system of a step: springs, and the pull of a scan across the cloth. Both forms hold the same
/// numbers.
struct Problem {
  BlockTriangle blocks;
  Sparse matrix;
  Eigen::MatrixXd right;  // a column per dimension, and one more
};

std::vector<std::array<int, 2>> pairs_of(const JointModel& model) {
  std::vector<std::array<int, 2>> out;
  for (const Spring& s : model.springs()) out.push_back({s.particle_a, s.particle_b});
  return out;
}

Problem problem_of(const JointModel& model) {
  const int n = model.pattern().particle_count;
  const Eigen::Index rows = 3 * static_cast<Eigen::Index>(n);
  Problem out{BlockTriangle(n, pairs_of(model)), Sparse(rows, rows), {}};
  std::vector<Eigen::Triplet<double>> all;
  const auto add = [&](int i, int j, const Eigen::Matrix3d& block) {
    out.blocks.add(i, j, block);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) all.emplace_back(3 * i + r, 3 * j + c, block(r, c));
  };
  for (std::size_t s = 0; s < model.springs().size(); ++s) {
    const auto [a, b] = std::pair(model.springs()[s].particle_a, model.springs()[s].particle_b);
    const double turn = static_cast<double>(s);
    const Vec3 along = Vec3(std::sin(turn), std::cos(turn), std::sin(2 * turn)).normalized();
    const Eigen::Matrix3d block = model.spring_weight(s) * along * along.transpose();
    add(a, a, block), add(b, b, block), add(a, b, -block), add(b, a, -block);
  }
  for (int i = 0; i < n; ++i) {
    const Vec3 normal = Vec3(std::sin(i), 0, std::cos(i));
    const double share = model.particle_areas()[i] / model.scales().patch;
    add(i, i,
        share * (kAcross * normal * normal.transpose() + kPull * Eigen::Matrix3d::Identity()));
  }
  out.matrix.setFromTriplets(all.begin(), all.end());
  out.right.resize(rows, static_cast<Eigen::Index>(model.dimension_count()) + 1);
  for (Eigen::Index c = 0; c < out.right.cols(); ++c)
    for (Eigen::Index i = 0; i < out.right.rows(); ++i)
      out.right(i, c) = std::sin(0.37 * static_cast<double>(i * (c + 1)));
  return out;
}

}  // namespace

void measure_solver(Bench& bench) {
  const GarmentTemplate skirt = find_template("skirt");
  GrowthCurve growth{"a step of the joint fit", "particles", {}, 0};
  bool compared = false;
  for (const double edge : {0.05, 0.035, 0.025, 0.0175, 0.0125, 0.009, 0.0064}) {
    const JointModel model(skirt, skirt.typical(), edge, JointScales{});
    const int n = model.pattern().particle_count;
    const Problem p = problem_of(model);
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
