#include "synthetic/scanner_cloth.h"

#include <gtest/gtest.h>

#include <map>

#include "base/error.h"
#include "scanner_figures.h"

namespace regarment {
namespace {

constexpr double kThickness = 0.004;
constexpr double kEdge = 0.02;

// A straight tube of cloth, so that every distance from the cloth's middle is one of radii.
test::ConeSkirt tube() { return {.waist = 1.0, .width = 1.0, .length = 0.5, .top = 1.0}; }

ScannerScene scene_of(const WornGarment& garment) {
  ScannerScene scene;
  add_cloth(garment, 1, scene);
  return scene;
}

SheetFabric fabric() {
  SheetFabric fabric;
  fabric.thickness = kThickness;
  return fabric;
}

double radius_of(const Vec3& p) { return std::hypot(p.x(), p.z()); }

TEST(ScannerCloth, SidesLieHalfTheThicknessOffTheMiddle) {
  const test::ConeSkirt skirt = tube();
  const ScannerScene scene = scene_of(skirt.worn(kEdge, fabric()));
  int inner = 0, outer = 0, walls = 0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    double low = 1e9, high = -1e9;
    for (const std::uint32_t v : scene.triangles[t]) {
      const double off = radius_of(scene.positions[v]) - skirt.radius(0);
      low = std::min(low, off), high = std::max(high, off);
    }
    if (high - low > 0.5 * kThickness) {
      // A wall at waist or hem: its whole height is the step a scan shows.
      EXPECT_NEAR(high - low, kThickness, 2e-4);
      ++walls;
    } else {
      EXPECT_NEAR(0.5 * (low + high), scene.inner[t] ? -kThickness / 2 : kThickness / 2, 1e-4);
      ++(scene.inner[t] ? inner : outer);
    }
    EXPECT_EQ(scene.owner[t], 1);
  }
  EXPECT_EQ(inner, outer);
  EXPECT_GT(outer, 1000);
  EXPECT_GT(walls, 150);
}

TEST(ScannerCloth, IsClosedWithTrianglesOutward) {
  const ScannerScene scene = scene_of(tube().worn(kEdge, fabric(), 0.03));
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  double volume = 0;
  for (const Triangle& t : scene.triangles) {
    for (int k = 0; k < 3; ++k) {
      ++uses[{t[k], t[(k + 1) % 3]}];
      --uses[{t[(k + 1) % 3], t[k]}];
    }
    volume += scene.positions[t[0]].dot(scene.positions[t[1]].cross(scene.positions[t[2]])) / 6;
  }
  for (const auto& [edge, balance] : uses) ASSERT_EQ(balance, 0);
  // The band's 3 cm count twice.
  const double expected = 1.0 * (0.5 + 0.03) * kThickness;
  EXPECT_NEAR(volume, expected, 0.005 * expected);
}

TEST(ScannerCloth, BandIsTwiceAsThickDownToItsEnd) {
  const test::ConeSkirt skirt = tube();
  const double band = 0.0337;  // no row of particles lies there
  const ScannerScene scene = scene_of(skirt.worn(kEdge, fabric(), band));
  double lowest_thick = 1e9, highest_thin = -1e9;
  for (const Triangle& t : scene.triangles)
    for (const std::uint32_t v : t) {
      const Vec3& p = scene.positions[v];
      const double off = std::abs(radius_of(p) - skirt.radius(0));
      if (off > 0.75 * kThickness)
        lowest_thick = std::min(lowest_thick, p.y());
      else
        highest_thin = std::max(highest_thin, p.y());
    }
  // m; the normals of a faceted tube tilt by up to five degrees.
  const double tilt = 0.09 * kThickness;
  EXPECT_NEAR(lowest_thick, skirt.top - band, tilt);
  EXPECT_NEAR(highest_thin, skirt.top - band, tilt);
}

TEST(ScannerCloth, RefusesParticlesOfAnotherPattern) {
  WornGarment garment = tube().worn(kEdge, fabric());
  ScannerScene scene;
  garment.particles.pop_back();
  EXPECT_THROW(add_cloth(garment, 1, scene), InvalidInput);
  garment.particles.emplace_back(std::nan(""), 0, 0);
  EXPECT_THROW(add_cloth(garment, 1, scene), InvalidInput);
}

}  // namespace
}  // namespace regarment
