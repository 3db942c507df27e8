#include "drape/cloth.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>

#include "base/error.h"
#include "cloths.h"
#include "garment/find_template.h"

namespace regarment {
namespace {

using namespace test;

struct Sample {
  GarmentTemplate garment;
  Pattern pattern;
  std::vector<Vec3> placed;  // front panels before, back panels behind, each as flat as it is
};

Sample sample(const std::string& name) {
  const GarmentTemplate garment = find_template(name);
  const Pattern pattern = make_pattern(garment, garment.typical(), 0.04);
  std::vector<Vec3> of_particle(static_cast<std::size_t>(pattern.particle_count));
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const double side = pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[v])] ? 1 : -1;
    of_particle[static_cast<std::size_t>(pattern.particle[v])] =
        Vec3(pattern.flat[v].x(), -pattern.flat[v].y(), 0.1 * side);
  }
  return {garment, pattern, at_vertices(pattern, of_particle)};
}

class ClothOf : public testing::TestWithParam<const char*> {};

TEST_P(ClothOf, HasOneParticlePerSeamPoint) {
  const Sample s = sample(GetParam());
  const Cloth cloth = make_cloth(s.pattern, s.placed);
  EXPECT_EQ(cloth.size(), static_cast<std::size_t>(s.pattern.particle_count));
  EXPECT_LT(cloth.size(), s.pattern.flat.size());
  EXPECT_EQ(at_vertices(s.pattern, cloth.positions), s.placed);
}

TEST_P(ClothOf, BendsAcrossEachInnerSideOnce) {
  const Sample s = sample(GetParam());
  const Cloth cloth = make_cloth(s.pattern, s.placed);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Triangle& t : cloth.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
  std::set<std::pair<int, int>> bent;
  for (const BendingElement& e : cloth.bending) {
    const auto side = std::minmax(e.particles[2], e.particles[3]);
    EXPECT_TRUE(bent.insert(side).second);
    EXPECT_EQ(
        (uses[{static_cast<std::uint32_t>(side.first), static_cast<std::uint32_t>(side.second)}]),
        2);
  }
  EXPECT_EQ(bent.size(),
            static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(),
                                                   [](const auto& u) { return u.second == 2; })));
}

TEST_P(ClothOf, TurnsBendingElementsOutwards) {
  const Sample s = sample(GetParam());
  const Cloth cloth = make_cloth(s.pattern, s.placed);
  const auto is_turn_of = [&](const Triangle& t, int a, int b, int c) {
    const std::array<int, 3> x = {static_cast<int>(t[0]), static_cast<int>(t[1]),
                                  static_cast<int>(t[2])};
    return x == std::array{a, b, c} || x == std::array{b, c, a} || x == std::array{c, a, b};
  };
  for (const BendingElement& e : cloth.bending) {
    const auto& p = e.particles;
    EXPECT_TRUE(
        is_turn_of(cloth.triangles[static_cast<std::size_t>(e.triangles[0])], p[0], p[2], p[3]));
    EXPECT_TRUE(
        is_turn_of(cloth.triangles[static_cast<std::size_t>(e.triangles[1])], p[1], p[3], p[2]));
  }
}

TEST_P(ClothOf, WeighsWhatItsAreaWeighs) {
  const Sample s = sample(GetParam());
  const std::vector<double> areas = triangle_areas(s.pattern);
  const Cloth cloth = make_cloth(s.pattern, s.placed, 0.3);
  EXPECT_NEAR(std::accumulate(cloth.masses.begin(), cloth.masses.end(), 0.0),
              0.3 * std::accumulate(areas.begin(), areas.end(), 0.0), 1e-12);
}

TEST_P(ClothOf, TakesNewLengthsWithoutMoving) {
  Sample s = sample(GetParam());
  Cloth cloth = make_cloth(s.pattern, s.placed);
  const std::vector<Vec3> before = cloth.positions;
  Dimensions longer = s.garment.typical();
  longer["length"] *= 1.1;
  move_pattern(s.garment, longer, s.pattern);
  update_cloth(s.pattern, cloth);
  EXPECT_EQ(cloth.positions, before);
  const Cloth fresh = make_cloth(s.pattern, s.placed);
  for (std::size_t i = 0; i < cloth.springs.size(); ++i)
    EXPECT_EQ(cloth.springs[i].rest_length, fresh.springs[i].rest_length);
  for (std::size_t i = 0; i < cloth.bending.size(); ++i) {
    EXPECT_EQ(cloth.bending[i].rest_side, fresh.bending[i].rest_side);
    EXPECT_EQ(cloth.bending[i].rest_normals, fresh.bending[i].rest_normals);
  }
  EXPECT_EQ(cloth.masses, fresh.masses);
}

INSTANTIATE_TEST_SUITE_P(Garments, ClothOf, testing::Values("skirt", "tshirt"));

TEST(Cloth, RefusesAPlacementOfAnotherPattern) {
  const Sample s = sample("skirt");
  EXPECT_THROW(make_cloth(s.pattern, std::vector<Vec3>(3)), InvalidInput);
  Cloth cloth = flat_patch(2, 0.1);
  EXPECT_THROW(update_cloth(s.pattern, cloth), InvalidInput);
}

TEST(Cloth, MeasuresItsMeanStretch) {
  Cloth cloth = flat_patch(3, 0.06);
  EXPECT_NEAR(mean_stretch(cloth), 1, 1e-15);
  for (Vec3& x : cloth.positions) x *= 1.25;
  EXPECT_NEAR(mean_stretch(cloth), 1.25, 1e-15);
  EXPECT_EQ(mean_stretch(one_particle(Vec3::Zero())), 1);
}

TEST(Cloth, PointsItsNormalsOutwards) {
  for (const Vec3& n : particle_normals(flat_patch(3, 0.06))) EXPECT_EQ(n, Vec3::UnitY());
  EXPECT_EQ(particle_normals(one_particle(Vec3(1, 2, 3)))[0], Vec3::Zero());
}

TEST(Cloth, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto broken = [](auto&& breaks) {
    Cloth cloth = flat_patch(2, 0.04);
    breaks(cloth);
    EXPECT_THROW(cloth.check(), InvalidInput);
  };
  EXPECT_NO_THROW(flat_patch(2, 0.04).check());
  broken([](Cloth& c) { c = {}; });
  broken([](Cloth& c) { c.velocities.pop_back(); });
  broken([](Cloth& c) { c.masses.pop_back(); });
  broken([&](Cloth& c) { c.positions[4].y() = nan; });
  broken([&](Cloth& c) { c.velocities[4].y() = nan; });
  broken([](Cloth& c) { c.masses[2] = 0; });
  broken([](Cloth& c) { c.triangles[1][2] = 9; });
  broken([](Cloth& c) { c.springs[3].particle_b = 9; });
  broken([](Cloth& c) { c.springs[3].particle_a = -1; });
  broken([](Cloth& c) { c.springs[3].particle_a = c.springs[3].particle_b; });
  broken([](Cloth& c) { c.springs[3].rest_length = 0; });
  broken([](Cloth& c) { c.bending[0].particles[1] = c.bending[0].particles[0]; });
  broken([](Cloth& c) { c.bending[0].particles[1] = 9; });
  broken([](Cloth& c) { c.bending[0].rest_normals[1] = 0; });
}

}  // namespace
}  // namespace regarment
