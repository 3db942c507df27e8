#include "drape/attraction_force.h"

#include <gtest/gtest.h>

#include "cloths.h"
#include "differences.h"
#include "surfaces.h"

namespace regarment {
namespace {

using namespace test;

constexpr double kStiffness = 4;

/// A slanted plane, so that no axis is special.
Mesh slanted_sheet() {
  Mesh mesh = sheet();
  const Eigen::AngleAxisd turn(0.5, Vec3(1, 0, 2).normalized());
  for (Vec3& p : mesh.positions) p = turn * p;
  return mesh;
}

TEST(AttractionForce, PullsWithStiffnessTimesDistance) {
  const Mesh mesh = sheet();
  const ClosestPoint scan = closest_on(mesh);
  Cloth cloth = one_particle(Vec3(0.1, 0.03, 0.2));
  std::vector<Attraction> targets = attract(cloth, scan, {});
  EXPECT_LT((forces_of(AttractionForce{kStiffness, 0, targets}, cloth)[0] -
             Vec3(0, -kStiffness * 0.03, 0))
                .norm(),
            1e-12);
  targets[0].weight = 0.25;
  EXPECT_NEAR(forces_of(AttractionForce{kStiffness, 0, targets}, cloth)[0].y(),
              -0.25 * kStiffness * 0.03, 1e-12);
  targets[0].share = 0.5;
  EXPECT_NEAR(forces_of(AttractionForce{kStiffness, 0, targets}, cloth)[0].y(),
              -0.125 * kStiffness * 0.03, 1e-12);
  EXPECT_NEAR(AttractionForce(kStiffness, 0, targets).energy(cloth),
              0.5 * 0.125 * kStiffness * 0.03 * 0.03, 1e-12);
  targets[0].pulls = false;
  EXPECT_EQ(forces_of(AttractionForce{kStiffness, 0, targets}, cloth)[0], Vec3::Zero());
  EXPECT_EQ(AttractionForce(kStiffness, 0, targets).energy(cloth), 0);
}

TEST(AttractionForce, IsTheSlopeOfItsEnergyToAPlane) {
  const Mesh mesh = slanted_sheet();
  const ClosestPoint scan = closest_on(mesh);
  Cloth cloth = flat_patch(2, 0.04);
  shake(cloth, 0.02, 0, 21);
  AttractionOptions plain;
  plain.by_normals = false;
  // The targets are looked up again at each place, as the cloth would find them.
  const auto energy = [&](const Cloth& c) {
    return AttractionForce{kStiffness, 0, attract(c, scan, plain)}.energy(c);
  };
  const std::vector<Attraction> targets = attract(cloth, scan, plain);
  EXPECT_LT(
      largest(forces_of(AttractionForce{kStiffness, 0, targets}, cloth), downhill(energy, cloth)),
      1e-9);
}

TEST(AttractionForce, SlidesOverAPlane) {
  const Mesh mesh = slanted_sheet();
  const ClosestPoint scan = closest_on(mesh);
  Cloth cloth = one_particle(Vec3(0.02, 0.05, -0.03));
  const std::vector<Attraction> targets = attract(cloth, scan, {});
  const auto forces = [&](const Cloth& c) {
    const std::vector<Attraction> found = attract(c, scan, {});
    return forces_of(AttractionForce{kStiffness, 0, found}, c);
  };
  const Eigen::MatrixXd exact = numerical_jacobian(forces, cloth, By::Position);
  const AttractionForce free{kStiffness, 0, targets};
  EXPECT_LT((dense(jacobian_of(free, cloth).by_position) - exact).norm(), 1e-8);
  // With a grip the Jacobian holds back along the plane as well.
  const AttractionForce held{kStiffness, 0.1, targets};
  const Mat3 n = targets[0].normal * targets[0].normal.transpose();
  const Mat3 extra = -0.1 * kStiffness * (Mat3::Identity() - n);
  EXPECT_LT((dense(jacobian_of(held, cloth).by_position) - exact - extra).norm(), 1e-8);
}

TEST(AttractionForce, SticksToAPointBesideIt) {
  const std::vector<Vec3> points = {Vec3::Zero()}, normals = {Vec3::UnitY()};
  const ClosestPoint cloud{std::span(points), std::span(normals)};
  const Cloth beside = one_particle(Vec3(0.01, 0, 0));
  const std::vector<Attraction> targets = attract(beside, cloud, {});
  const auto forces = [&](const Cloth& c) {
    const std::vector<Attraction> found = attract(c, cloud, {});
    return forces_of(AttractionForce{kStiffness, 0, found}, c);
  };
  EXPECT_LT((dense(jacobian_of(AttractionForce{kStiffness, 0, targets}, beside).by_position) -
             numerical_jacobian(forces, beside, By::Position))
                .norm(),
            1e-8);
}

TEST(AttractionForce, KeepsStillWhereItIsPulledNowhere) {
  const std::vector<Vec3> points = {Vec3(1, 2, 3)};
  const ClosestPoint cloud{std::span(points), std::span<const Vec3>()};
  const Cloth cloth = one_particle(points[0]);
  const std::vector<Attraction> targets = attract(cloth, cloud, {});
  const AttractionForce force{kStiffness, 0.01, targets};
  EXPECT_EQ(forces_of(force, cloth)[0], Vec3::Zero());
  EXPECT_TRUE(dense(jacobian_of(force, cloth).by_position).allFinite());
}

}  // namespace
}  // namespace regarment
