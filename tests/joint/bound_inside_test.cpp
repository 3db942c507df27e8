#include "joint/bound_inside.h"

#include <gtest/gtest.h>

#include "joint/joint_fit.h"
#include "joint/joint_system.h"
#include "rolled_skirt.h"

namespace regarment {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A tube about the y axis, upper edge at y = 1.
OuterGarment tube_over(double girth, double length) {
  const Pattern pattern =
      make_pattern(find_template("skirt"), tube_dimensions(girth, length), 0.02);
  return outer_garment(pattern, rolled(pattern, girth, girth / kTurn));
}

ClosestPoint surface_of(const OuterGarment& garment) {
  return {garment.particles, garment.triangles};
}

double radius_of(const Vec3& p) { return std::hypot(p.x(), p.z()); }

/// A skirt of 1 m girth and 0.6 m length under a tube of the same girth and 0.3 m length; its own
/// radius is larger by `proud`.
struct Problem {
  JointModel model{find_template("skirt"), tube_dimensions(1.0, 0.6), 0.06, JointScales{}};
  std::vector<ClosestPoint> outer;
  std::vector<Vec3> x;
  InsideOptions options;

  explicit Problem(double proud) {
    outer.push_back(surface_of(tube_over(1.0, 0.3)));
    x = particles_of(model.pattern(), rolled(model.pattern(), 1.0, 1.0 / kTurn + proud));
    bound_inside(outer, x, std::vector<double>(x.size(), 0.0), options, model);
  }
};

TEST(OuterGarment, HasNoBordersButItsOpenEdges) {
  const OuterGarment tube = tube_over(1.0, 0.3);
  const ClosestPoint surface = surface_of(tube);
  for (const double phi : {0.0, 0.5 * std::numbers::pi, -0.5 * std::numbers::pi})
    EXPECT_FALSE(surface.closest(Vec3(std::sin(phi), 0.85, std::cos(phi))).on_border) << phi;
  EXPECT_TRUE(surface.closest(Vec3(0, 0.5, 0.2)).on_border);
}

TEST(BoundInside, BoundsWhatIsCoveredAndNothingElse) {
  const Problem problem(0.005);
  std::vector<int> times(problem.x.size(), 0);
  for (const InsideBound& bound : problem.model.inside) {
    ++times[static_cast<std::size_t>(bound.particle)];
    // The triangles of the tube lie within it by less than a millimetre: sides of 3 cm, their
    // sagitta.
    EXPECT_NEAR(radius_of(bound.point), 1.0 / kTurn - problem.options.thickness, 0.001);
    EXPECT_GT(bound.weight, 0);
  }
  for (std::size_t i = 0; i < problem.x.size(); ++i) {
    const double y = problem.x[i].y();
    if (y > 0.71 && y < 0.99) {
      EXPECT_EQ(times[i], 1) << y;
    } else if (y < 0.69) {
      EXPECT_EQ(times[i], 0) << y;
    }
  }
}

TEST(BoundInside, LeavesWhatTheScanShowsAndWhatIsFarBeyond) {
  Problem near(0.005), far(0.06);
  const double alone = near.model.inside.at(0).weight;
  bound_inside(near.outer, near.x, std::vector<double>(near.x.size(), 0.75), near.options,
               near.model);
  EXPECT_NEAR(near.model.inside.at(0).weight, 0.25 * alone, 1e-9 * alone);
  bound_inside(near.outer, near.x, std::vector<double>(near.x.size(), 1.0), near.options,
               near.model);
  EXPECT_TRUE(near.model.inside.empty());
  // 6 cm are three times `robust`: 1 / (1 + 9)^2 of the weight.
  EXPECT_LT(far.model.inside.at(0).weight, 0.015 * alone);
}

// What the term adds to the energy, and with it the force on each particle, by central differences.
TEST(BoundInside, PushesBackAsItsEnergySays) {
  Problem problem(0.005);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
  JointModel free = problem.model;
  free.inside.clear();
  const auto term = [&](const std::vector<Vec3>& x) {
    return problem.model.energy(x, none) - free.energy(x, none);
  };
  constexpr double kStep = 1e-6;
  for (std::size_t b = 0; b < problem.model.inside.size(); b += 7) {
    const InsideBound& bound = problem.model.inside[b];
    const double beyond = bound.outward.dot(problem.x[bound.particle] - bound.point);
    ASSERT_GT(beyond, 0.005);
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Vec3> above = problem.x, below = problem.x;
      above[bound.particle][axis] += kStep, below[bound.particle][axis] -= kStep;
      const double slope = (term(above) - term(below)) / (2 * kStep);
      EXPECT_NEAR(slope, bound.weight * beyond * bound.outward[axis], 1e-4 * bound.weight * beyond);
    }
  }
}

TEST(BoundInside, CostsNothingInside) {
  const Problem problem(-0.01);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
  JointModel free = problem.model;
  free.inside.clear();
  EXPECT_FALSE(problem.model.inside.empty());
  EXPECT_EQ(problem.model.energy(problem.x, none), free.energy(problem.x, none));
  JointSystem bound_system(problem.model), free_system(free);
  const std::vector<bool> held(4, false);
  EXPECT_EQ(bound_system.step(problem.model, problem.x, held, {}).positions,
            free_system.step(free, problem.x, held, {}).positions);
}

// The gradient that the system solves with is that of the energy: with the dimensions held, the
// energy along its step falls as the difference of energies says.
TEST(BoundInside, StepFollowsTheEnergy) {
  Problem problem(0.005);
  JointSystem system(problem.model);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
  const JointStep way =
      system.step(problem.model, problem.x, std::vector<bool>(4, true), {0.05, 0.05, 0.05});
  std::vector<Vec3> after = problem.x;
  for (std::size_t i = 0; i < after.size(); ++i) after[i] += way.positions[i];
  EXPECT_LT(problem.model.energy(after, none), problem.model.energy(problem.x, none));
  double covered = 0, n = 0;
  for (const InsideBound& bound : problem.model.inside)
    covered += bound.outward.dot(after[bound.particle] - problem.x[bound.particle]), n += 1;
  EXPECT_LT(covered / n, -0.002);
}

// A skirt seen only below a narrower tube that covers its upper half: fitted without it, the hidden
// half goes on as what is seen; with it, it stays inside.
TEST(BoundInside, KeepsTheHiddenPartOfAFitInside) {
  JointTarget target = tube_target(1.1, 0.6);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    if (target.points[i].y() > 0.65) continue;
    target.points[kept] = target.points[i], target.normals[kept] = target.normals[i];
    target.areas[kept++] = target.areas[i];
  }
  target.points.resize(kept), target.normals.resize(kept), target.areas.resize(kept);
  target.edges.at("waist") = {target.edges.at("waist").curve, 0.04, true};
  JointOptions quick;
  quick.levels = {{0.06, 20, 0.04}, {0.04, 10, 0.02}};
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions start = tube_dimensions(1.1, 0.6);
  const Pattern pattern = make_pattern(skirt, start, 0.05);
  const auto highest = [&](const JointTarget& seen) {
    const JointFit fit =
        joint_fit(skirt, start, pattern, rolled(pattern, 1.1, 1.1 / kTurn), seen, {}, quick, {});
    double most = 0;
    for (const Vec3& p : fit.draped)
      if (p.y() > 0.75 && p.y() < 0.95) most = std::max(most, radius_of(p));
    // What is seen stays so, though the garment now has to taper above.
    EXPECT_NEAR(fit.dimensions.at("width"), 1.1, 0.03);
    return most;
  };
  EXPECT_GT(highest(target), 1.0 / kTurn + 0.005);
  target.outer.push_back(tube_over(1.0, 0.3));
  // 3 mm: one standard deviation of the term.
  EXPECT_LT(highest(target), 1.0 / kTurn - quick.inside.thickness + 0.003);
}

}  // namespace
}  // namespace regarment
