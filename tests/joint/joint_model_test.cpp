#include "joint/joint_model.h"

#include <gtest/gtest.h>

#include "joint/joint_system.h"
#include "rolled_skirt.h"

namespace regarment {
namespace {

/// A skirt on a tube that is wider, tapers and has folds, so that everything pulls.
struct Problem {
  JointModel model{find_template("skirt"), tube_dimensions(1.0, 0.5), 0.06, JointScales{}};
  std::vector<Vec3> x;

  Problem() {
    x = particles_of(model.pattern(), rolled(model.pattern(), 1.0, 0.165));
    for (Vec3& p : x) {
      const double fold = 1 + 0.04 * (1 - p.y()) * std::cos(7 * std::atan2(p.x(), p.z()));
      p.x() *= fold, p.z() *= fold;
    }
    match_scan(tube_target(1.04, 0.52), x, {}, model);
    model.lengths.push_back({0.53, 0.01, 0.5, Eigen::Vector4d(1, 0, 0, 0)});
  }

  /// Particles where E is smallest with the dimensions moved by `step`.
  std::vector<Vec3> settled(const Eigen::VectorXd& step) {
    JointModel moved = model;
    Dimensions there = model.dimensions();
    for (int k = 0; k < 4; ++k) there[model.flat().names[static_cast<std::size_t>(k)]] += step[k];
    moved.move_to(there);
    JointSystem system(moved);
    std::vector<Vec3> at = x;
    for (int round = 0; round < 200; ++round) {
      const JointStep way = system.step(moved, at, std::vector<bool>(4, true), {1e3, 1e3, 0.02});
      double longest = 0;
      for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] += way.positions[i];
        longest = std::max(longest, way.positions[i].norm());
      }
      if (longest < 1e-12) break;
    }
    return at;
  }
};

// The envelope theorem against central differences of the energy, solved again on both sides.
TEST(JointModel, GradientIsThatOfTheEnergySolvedAgain) {
  Problem problem;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
  const Eigen::VectorXd gradient = problem.model.dimension_gradient(problem.settled(none));
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 4; ++k) {
    Eigen::VectorXd step = none;
    step[k] = kStep;
    const double above = problem.model.energy(problem.settled(step), step);
    const double below = problem.model.energy(problem.settled(-step), -step);
    EXPECT_NEAR(gradient[k], (above - below) / (2 * kStep), 1e-4 * gradient.norm()) << k;
  }
}

TEST(JointModel, DirectGradientIsThatOfTheEnergy) {
  const Problem problem;
  const Eigen::VectorXd gradient = problem.model.dimension_gradient(problem.x);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 4; ++k) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(4);
    step[k] = kStep;
    const double slope =
        (problem.model.energy(problem.x, step) - problem.model.energy(problem.x, -step)) /
        (2 * kStep);
    EXPECT_NEAR(gradient[k], slope, 1e-4 * gradient.norm()) << k;
  }
}

TEST(JointSystem, AStepLowersTheEnergy) {
  Problem problem;
  JointSystem system(problem.model);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
  const JointStep way =
      system.step(problem.model, problem.x, std::vector<bool>(4, false), {0.05, 0.05, 0.05});
  std::vector<Vec3> after = problem.x;
  for (std::size_t i = 0; i < after.size(); ++i) after[i] += way.positions[i];
  EXPECT_LT(problem.model.energy(after, way.dimensions), problem.model.energy(problem.x, none));
}

TEST(JointSystem, NoParticleGoesFurtherThanAllowed) {
  Problem problem;
  JointSystem system(problem.model);
  const JointStep way =
      system.step(problem.model, problem.x, std::vector<bool>(4, false), {10, 10, 0.001});
  double longest = 0;
  for (const Vec3& p : way.positions) longest = std::max(longest, p.norm());
  EXPECT_TRUE(way.shortened);
  EXPECT_NEAR(longest, 0.001, 1e-12);
}

TEST(JointSystem, HeldDimensionsStay) {
  Problem problem;
  JointSystem system(problem.model);
  const std::vector<bool> held = {false, true, false, true};
  const JointStep way = system.step(problem.model, problem.x, held, {});
  EXPECT_EQ(way.dimensions[1], 0);
  EXPECT_EQ(way.dimensions[3], 0);
  EXPECT_NE(way.dimensions[0], 0);
}

}  // namespace
}  // namespace regarment
