#include "garment/springs.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "garment_samples.h"

namespace regarment {
namespace {

/// Two right triangles, one a front and one a back panel, sewn along their common side of 5 m.
Pattern two_triangles() {
  Pattern pattern;
  pattern.flat = {{0, 0}, {3, 0}, {0, 4}, {0, 4}, {3, 0}, {0, 0}};
  pattern.panel = {0, 0, 0, 1, 1, 1};
  pattern.particle = {0, 1, 2, 2, 1, 3};
  pattern.triangles = {{0, 2, 1}, {4, 3, 5}};
  pattern.panel_is_front = {true, false};
  pattern.particle_count = 4;
  return pattern;
}

TEST(Springs, AreAllPairsOfParticlesOnce) {
  std::map<std::pair<int, int>, double> lengths;
  for (const Spring& s : springs(two_triangles())) {
    EXPECT_LT(s.particle_a, s.particle_b);
    lengths[{s.particle_a, s.particle_b}] = s.rest_length;
  }
  const std::map<std::pair<int, int>, double> expected = {
      {{0, 1}, 3}, {{0, 2}, 4}, {{1, 2}, 5}, {{1, 3}, 3}, {{2, 3}, 4}};
  EXPECT_EQ(lengths, expected);
}

TEST(Springs, GiveEachParticleAThirdOfItsTriangles) {
  // Triangles of 6 m^2 and 0.5 kg/m^2: 1 kg for each corner.
  EXPECT_EQ(triangle_areas(two_triangles()), (std::vector<double>{6.0, 6.0}));
  const std::vector<double> masses = particle_masses(two_triangles(), 0.5);
  const std::vector<double> expected = {1.0, 2.0, 2.0, 1.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(masses[i], expected[i], 1e-15);
  EXPECT_THROW(particle_masses(two_triangles(), 0.0), InvalidInput);
}

TEST(Springs, OfAGarmentAgreeOnBothSidesOfASeam) {
  for (const std::string name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    Pattern pattern = make_pattern(garment, garment.typical(), 0.04);
    std::vector<Spring> all = springs(pattern);
    for (const Dimensions& d : test::possible_dimensions(garment, 20)) {
      move_pattern(garment, d, pattern);
      update_rest_lengths(pattern, all);
      std::map<std::pair<int, int>, std::vector<double>> by_hand;
      double area = 0.0, mass = 0.0;
      for (const Triangle& t : pattern.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t a = t[k], b = t[(k + 1) % 3];
          by_hand[std::minmax(pattern.particle[a], pattern.particle[b])].push_back(
              (pattern.flat[a] - pattern.flat[b]).norm());
        }
      ASSERT_EQ(by_hand.size(), all.size());
      for (const Spring& s : all)
        for (const double length : by_hand.at({s.particle_a, s.particle_b}))
          EXPECT_NEAR(length, s.rest_length, 1e-12);
      for (const double a : triangle_areas(pattern)) area += a;
      for (const double m : particle_masses(pattern, 0.2)) mass += m;
      EXPECT_NEAR(mass, 0.2 * area, 1e-12);
    }
  }
}

}  // namespace
}  // namespace regarment
