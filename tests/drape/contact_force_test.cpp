#include "drape/contact_force.h"

#include <gtest/gtest.h>

#include "cloths.h"
#include "differences.h"
#include "surfaces.h"

namespace regarment {
namespace {

using namespace test;

constexpr double kStiffness = 200, kThickness = 0.002;

Forces contact_forces(const Cloth& cloth, const ClosestPoint& scan) {
  const std::vector<Contact> contacts = find_contacts(cloth, scan);
  return forces_of(ContactForce{kStiffness, kThickness, contacts}, cloth);
}

TEST(ContactForce, PushesOutByTheMissingDistance) {
  const Mesh mesh = sheet();
  const ClosestPoint scan = closest_on(mesh);
  const auto push = [&](double y) { return contact_forces(one_particle(Vec3(0.3, y, 0.1)), scan); };
  EXPECT_NEAR(push(0.0005)[0].y(), kStiffness * 0.0015, 1e-12);
  EXPECT_NEAR(push(-0.004)[0].y(), kStiffness * 0.006, 1e-12);
  EXPECT_EQ(push(0.0021)[0], Vec3::Zero());
  EXPECT_EQ(push(0.04)[0], Vec3::Zero());
}

TEST(ContactForce, IsTheSlopeOfItsEnergy) {
  const Mesh mesh = sheet();
  const ClosestPoint scan = closest_on(mesh);
  Cloth cloth = flat_patch(2, 0.04);
  shake(cloth, 0.004, 0, 31);
  const auto energy = [&](const Cloth& c) {
    return ContactForce{kStiffness, kThickness, find_contacts(c, scan)}.energy(c);
  };
  EXPECT_GT(energy(cloth), 0);
  EXPECT_LT(largest(contact_forces(cloth, scan), downhill(energy, cloth)), 1e-9);
}

TEST(ContactForce, HasItsJacobianOnAPlane) {
  const Mesh mesh = sheet();
  const ClosestPoint scan = closest_on(mesh);
  for (const double y : {-0.003, 0.001, 0.01}) {
    const Cloth cloth = one_particle(Vec3(0.3, y, 0.1));
    const std::vector<Contact> contacts = find_contacts(cloth, scan);
    const auto forces = [&](const Cloth& c) { return contact_forces(c, scan); };
    EXPECT_LT(
        (dense(jacobian_of(ContactForce{kStiffness, kThickness, contacts}, cloth).by_position) -
         numerical_jacobian(forces, cloth, By::Position))
            .norm(),
        1e-6)
        << y;
  }
}

TEST(FindContacts, FindsNoneFarAwayAndNoneWithoutAnOutside) {
  const Mesh mesh = sheet();
  EXPECT_EQ(find_contacts(one_particle(Vec3(0, 0.2, 0)), closest_on(mesh))[0].normal, Vec3::Zero());
  const std::vector<Vec3> points = {Vec3::Zero()};
  const ClosestPoint cloud{std::span(points), std::span<const Vec3>()};
  EXPECT_EQ(contact_forces(one_particle(Vec3(0, 0.001, 0)), cloud)[0], Vec3::Zero());
}

}  // namespace
}  // namespace regarment
