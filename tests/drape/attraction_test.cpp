#include "drape/attraction.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"
#include "cloths.h"
#include "surfaces.h"

namespace regarment {
namespace {

using namespace test;

Cloth patch_at(double y, bool faces_up = true) {
  Cloth cloth = flat_patch(2, 0.04);
  if (!faces_up)
    for (Triangle& t : cloth.triangles) std::swap(t[1], t[2]);
  for (Vec3& x : cloth.positions) x.y() += y;
  return cloth;
}

/// A limb two centimetres thick: a sheet that faces up over one that faces down.
Mesh thin_limb() {
  Mesh mesh;
  add_sheet(1, 0.01, true, mesh);
  add_sheet(1, -0.01, false, mesh);
  return mesh;
}

TEST(Attract, GoesToTheClosestPoint) {
  const Mesh mesh = sheet(0.5);
  const std::vector<Attraction> found = attract(patch_at(0.53), closest_on(mesh), {});
  for (const Attraction& a : found) {
    EXPECT_TRUE(a.found && a.pulls);
    EXPECT_NEAR(a.target.y(), 0.5, 1e-12);
    EXPECT_NEAR(a.distance, 0.03, 1e-12);
    EXPECT_EQ(a.weight, 1);
    EXPECT_NEAR(a.normal.y(), 1, 1e-12);
  }
}

// Two sheets side by side, the second an outer garment's.
TEST(Attract, KnowsHowStronglyEachPartAttracts) {
  Mesh mesh = sheet(0, 1);
  add_sheet(1, 0, true, mesh);
  for (std::size_t v = 4; v < 8; ++v) mesh.positions[v].x() += 1;
  const ClosestPoint scan = closest_on(mesh);
  const std::vector<float> shares = {1, 1, 0.1F, 0.1F};
  EXPECT_EQ(attract(one_particle(Vec3(0.2, 0.1, 0.1)), scan, {}, {}, shares)[0].share, 1);
  EXPECT_EQ(attract(one_particle(Vec3(0.8, 0.1, 0.1)), scan, {}, {}, shares)[0].share, 0.1F);
  EXPECT_EQ(attract(one_particle(Vec3(0.8, 0.1, 0.1)), scan, {})[0].share, 1);
}

TEST(Attract, SendsAnUndersideToTheUnderside) {
  const Mesh limb = thin_limb();
  for (const Attraction& a : attract(patch_at(0.03, false), closest_on(limb), {}))
    EXPECT_NEAR(a.target.y(), -0.01, 1e-12);
  for (const Attraction& a : attract(patch_at(-0.03, true), closest_on(limb), {}))
    EXPECT_NEAR(a.target.y(), 0.01, 1e-12);
}

TEST(Attract, SendsAllToTheNearerSideWithoutNormals) {
  const Mesh limb = thin_limb();
  AttractionOptions plain;
  plain.by_normals = false;
  for (const Attraction& a : attract(patch_at(0.03, false), closest_on(limb), plain))
    EXPECT_NEAR(a.target.y(), 0.01, 1e-12);
}

TEST(Attract, LooksAtNoNormalWhereTold) {
  const Mesh limb = thin_limb();
  std::vector<std::uint8_t> any_side(9, 0);
  any_side[4] = 1;
  const std::vector<Attraction> found =
      attract(patch_at(0.03, false), closest_on(limb), {}, any_side);
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i].target.y(), i == 4 ? 0.01 : -0.01, 1e-12);
}

TEST(Attract, FindsNothingThatFacesTheOtherWay) {
  const Mesh mesh = sheet();
  const std::vector<Attraction> found = attract(patch_at(0.03, false), closest_on(mesh), {});
  for (const Attraction& a : found) EXPECT_FALSE(a.found || a.pulls);
  EXPECT_DOUBLE_EQ(mean_distance(found), 0.1);
}

TEST(Attract, KeepsTheAngleAsked) {
  const Mesh mesh = sheet();
  Cloth cloth = patch_at(0.05);
  const Eigen::AngleAxisd turn(0.9, Vec3::UnitX());  // 52 degrees
  for (Vec3& x : cloth.positions) x = turn * x;
  AttractionOptions options;
  options.normal_angle = 0.95;
  for (const Attraction& a : attract(cloth, closest_on(mesh), options)) EXPECT_TRUE(a.found);
  options.normal_angle = 0.85;
  for (const Attraction& a : attract(cloth, closest_on(mesh), options)) EXPECT_FALSE(a.found);
}

TEST(Attract, IsNotPulledByABorder) {
  const Mesh small = sheet(0, 0.02);  // the cloth reaches out over it
  const Cloth cloth = patch_at(0.005);
  const std::vector<Attraction> found = attract(cloth, closest_on(small), {});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vec3& x = cloth.positions[i];
    const bool over = std::abs(x.x()) < 0.01 && std::abs(x.z()) < 0.01;
    EXPECT_EQ(found[i].pulls, over) << i;
    EXPECT_TRUE(found[i].found);
  }
  AttractionOptions as_printed;
  as_printed.border_rejection = false;
  for (const Attraction& a : attract(cloth, closest_on(small), as_printed)) EXPECT_TRUE(a.pulls);
}

TEST(Attract, GoesToAnyPointWhereTheClothHasNoNormal) {
  Cloth cloth = one_particle(Vec3(0, 0.02, 0));
  const Mesh mesh = sheet();
  EXPECT_NEAR(attract(cloth, closest_on(mesh), {})[0].distance, 0.02, 1e-12);
}

TEST(Attract, GoesToPointsOfACloud) {
  const std::vector<Vec3> points = {Vec3(0, 0, 0), Vec3(0.1, 0, 0)};
  const std::vector<Vec3> normals(2, Vec3::UnitY());
  const ClosestPoint cloud{std::span(points), std::span(normals)};
  const Cloth cloth = one_particle(Vec3(0.07, 0.04, 0));
  const Attraction a = attract(cloth, cloud, {})[0];
  EXPECT_EQ(a.target, points[1]);
  EXPECT_NEAR(a.distance, 0.05, 1e-12);
}

TEST(MeanDistance, CountsWhatIsNotFoundAsFar) {
  Attraction near, border, none;
  near.found = near.pulls = true, near.distance = 0.02;
  border.found = true, border.distance = 0.04;
  EXPECT_DOUBLE_EQ(mean_distance({near, border, none}), (0.02 + 0.04 + 0.1) / 3);
  EXPECT_DOUBLE_EQ(mean_distance({near, none}, 0.5), 0.26);
}

TEST(AttractionOptions, NamesTheFieldAndItsValue) {
  for (const double angle : {0.0, -1.0, 3.2, std::numeric_limits<double>::quiet_NaN()}) {
    AttractionOptions options;
    options.normal_angle = angle;
    EXPECT_THROW(options.check(), InvalidInput) << angle;
  }
}

}  // namespace
}  // namespace regarment
