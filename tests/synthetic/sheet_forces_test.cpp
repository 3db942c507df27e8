#include "synthetic/sheet_forces.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "made_sheets.h"

namespace regarment {
namespace {

std::vector<Vec3> crumpled(const Pattern& pattern, double by) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-by, by);
  return placed(pattern, [&](const Vec2& p) {
    return Vec3(0.97 * p.x() + off(random), -0.98 * p.y() + off(random), off(random));
  });
}

using Energy = double (*)(const Sheet&, const std::vector<Vec3>&);
using Forces = void (*)(const Sheet&, const std::vector<Vec3>&, std::vector<Vec3>&);

void expect_minus_gradient(Energy energy, Forces add_forces) {
  const Pattern pattern = grid_pattern(4, 3, 0.02);
  const Sheet sheet = make_sheet(pattern, {}, 0.03);
  // Pressed together, so that no element is longer than at rest: there the energy is exact.
  std::vector<Vec3> x = crumpled(pattern, 0.0005);
  std::vector<Vec3> forces(x.size(), Vec3::Zero());
  add_forces(sheet, x, forces);
  const double step = 1e-7;  // m
  for (std::size_t p = 0; p < x.size(); ++p)
    for (int k = 0; k < 3; ++k) {
      const double there = x[p][k];
      x[p][k] = there + step;
      const double above = energy(sheet, x);
      x[p][k] = there - step;
      const double below = energy(sheet, x);
      x[p][k] = there;
      EXPECT_NEAR(forces[p][k], -(above - below) / (2 * step), 1e-5 * (1 + std::abs(forces[p][k])))
          << "particle " << p << " axis " << k;
    }
}

TEST(SheetForces, OfStrainAreMinusItsGradient) {
  expect_minus_gradient(strain_energy, add_strain_forces);
}

TEST(SheetForces, OfBendingAreMinusItsGradient) {
  expect_minus_gradient(bending_energy, add_bending_forces);
}

TEST(SheetForces, NeitherMoveNorTurnAFreeSheet) {
  const Pattern pattern = grid_pattern(5, 4, 0.02);
  const Sheet sheet = make_sheet(pattern, {});
  const std::vector<Vec3> x = crumpled(pattern, 0.004);
  std::vector<Vec3> forces(x.size(), Vec3::Zero());
  add_strain_forces(sheet, x, forces);
  Vec3 sum = Vec3::Zero(), turn = Vec3::Zero();
  for (std::size_t p = 0; p < x.size(); ++p) sum += forces[p], turn += x[p].cross(forces[p]);
  EXPECT_LT(sum.norm(), 1e-9);
  EXPECT_LT(turn.norm(), 1e-9);
}

// A sheet rolled on a cylinder has one curvature 1 / R: its energy is B / (2 R^2) per area,
// whichever way it is rolled. Its free edges, about half a triangle wide, bend less.
TEST(SheetForces, BendAsAPlateDoes) {
  const int cells = 60;
  const double h = 0.005, radius = 0.1;
  const Pattern pattern = lattice_pattern(cells, cells, h);
  SheetFabric fabric;
  fabric.bending = 1e-4;
  const Sheet sheet = make_sheet(pattern, fabric);
  double area = 0;
  for (const double a : sheet.area) area += a;
  for (const double direction : {0.0, 0.2, 0.5, 1.2}) {
    const std::vector<Vec3> x = placed(pattern, [&](const Vec2& p) {
      const double along = std::cos(direction) * p.x() + std::sin(direction) * p.y();
      const double across = std::cos(direction) * p.y() - std::sin(direction) * p.x();
      return Vec3(radius * std::sin(along / radius), -across, radius * std::cos(along / radius));
    });
    const double expected = 0.5 * fabric.bending / (radius * radius) * area;
    EXPECT_NEAR(bending_energy(sheet, x), expected, 0.05 * expected) << direction << " rad";
  }
}

TEST(SheetForces, TwoLayersPullTwiceAndBendEightTimesAsHard) {
  const Pattern pattern = grid_pattern(4, 4, 0.02);
  const Sheet one = make_sheet(pattern, {}), two = make_sheet(pattern, {}, 1.0);
  const std::vector<Vec3> x = crumpled(pattern, 0.002);
  EXPECT_NEAR(strain_energy(two, x), 2 * strain_energy(one, x), 1e-12);
  EXPECT_NEAR(bending_energy(two, x), 8 * bending_energy(one, x), 1e-12);
}

// The quasi-Newton method goes downhill only if the bound is no softer than the energy anywhere.
TEST(SheetForces, NeverAreStifferThanTheirBound) {
  const Pattern pattern = grid_pattern(3, 2, 0.02);
  const Sheet sheet = make_sheet(pattern, {});
  const Eigen::MatrixXd lower = stiffness_bound(sheet);
  const auto n = lower.rows();
  Eigen::MatrixXd bound = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      for (Eigen::Index k = 0; k < 3; ++k)
        bound(3 * i + k, 3 * j + k) = bound(3 * j + k, 3 * i + k) = lower(i, j);
  const auto all_forces = [&](const std::vector<Vec3>& x) {
    std::vector<Vec3> f(x.size(), Vec3::Zero());
    add_strain_forces(sheet, x, f);
    add_bending_forces(sheet, x, f);
    return f;
  };
  std::vector<Vec3> x = crumpled(pattern, 0.0005);
  Eigen::MatrixXd hessian(3 * n, 3 * n);
  const double step = 1e-7;
  for (Eigen::Index j = 0; j < 3 * n; ++j) {
    double& at = x[static_cast<std::size_t>(j / 3)][j % 3];
    const double there = at;
    at = there + step;
    const auto above = all_forces(x);
    at = there - step;
    const auto below = all_forces(x);
    at = there;
    for (Eigen::Index i = 0; i < 3 * n; ++i)
      hessian(i, j) = -(above[static_cast<std::size_t>(i / 3)][i % 3] -
                        below[static_cast<std::size_t>(i / 3)][i % 3]) /
                      (2 * step);
  }
  const Eigen::MatrixXd difference = bound - 0.5 * (hessian + hessian.transpose());
  const double least =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(difference).eigenvalues().minCoeff();
  EXPECT_GT(least, -1e-3 * bound.diagonal().maxCoeff());
}

}  // namespace
}  // namespace regarment
