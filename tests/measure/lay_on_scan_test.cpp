#include "measure/lay_on_scan.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.h"
#include "garment/find_template.h"
#include "garment/springs.h"
#include "support/limbs.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;

/// A frustum that a skirt of its measures covers exactly. Heights above the floor, m.
struct Frustum {
  double waist_radius = 0.13, hem_radius = 0.20, waist_y = 1.0,
         length = 0.5;  // length along the slant

  double slope() const {
    return (hem_radius - waist_radius) / length;
  }  // m of radius per m of slant
  double hem_y() const { return waist_y - length * std::sqrt(1 - slope() * slope()); }
  double radius(double y) const {
    return waist_radius + (hem_radius - waist_radius) * (waist_y - y) / (waist_y - hem_y());
  }
  Dimensions dimensions() const {
    return {{"length", length},
            {"waist", 2 * kPi * waist_radius},
            {"hip", 2 * kPi * (waist_radius + 0.2 * slope())},
            {"width", 2 * kPi * hem_radius}};
  }
  std::vector<Vec3> circle(double y) const {
    std::vector<Vec3> points;
    for (int k = 0; k < 144; ++k)
      points.emplace_back(radius(y) * std::sin(2 * kPi * k / 144), y,
                          radius(y) * std::cos(2 * kPi * k / 144));
    return points;
  }
};

struct Laid {
  Pattern pattern;
  std::vector<Vec3> placed, draped;
};

Laid lay(const Frustum& frustum, double offset) {
  const GarmentTemplate skirt = find_template("skirt");
  Laid laid;
  laid.pattern = make_pattern(skirt, frustum.dimensions(), 0.025);
  test::LimbPlan limb;
  limb.low = frustum.hem_y(), limb.high = frustum.waist_y, limb.spacing = 0.005;
  limb.radius = [&](double y, double) { return frustum.radius(y); };
  const SurfaceSamples samples = test::limb_samples(limb, 51);
  // Placed outside of the frustum, by panel angle, and too high.
  for (std::size_t v = 0; v < laid.pattern.flat.size(); ++v) {
    const Vec2& p = laid.pattern.flat[v];
    const double share = p.y() / frustum.length;
    const double half =
        0.5 * kPi * (frustum.waist_radius + share * (frustum.hem_radius - frustum.waist_radius));
    double phi = std::clamp(p.x() / half, -1.0, 1.0) * kPi / 2;
    if (!laid.pattern.panel_is_front[static_cast<std::size_t>(laid.pattern.panel[v])])
      phi = kPi - phi;
    const double y = frustum.waist_y + share * (frustum.hem_y() - frustum.waist_y);
    const double r = frustum.radius(y) + offset;
    laid.placed.emplace_back(r * std::sin(phi), y, r * std::cos(phi));
  }
  laid.draped = lay_on_scan(
      laid.pattern, laid.placed, samples, std::vector<std::uint8_t>(samples.size(), 1),
      {{"waist", frustum.circle(frustum.waist_y)}, {"hem", frustum.circle(frustum.hem_y())}});
  return laid;
}

double mean_stretch(const Laid& laid) {
  double sum = 0;
  const std::vector<Spring> links = springs(laid.pattern);
  for (const Spring& s : links)
    sum += (laid.draped[s.vertex_a] - laid.draped[s.vertex_b]).norm() / s.rest_length /
           static_cast<double>(links.size());
  return sum;
}

TEST(LayOnScan, ASkirtLiesOnItsOwnFrustum) {
  for (const Frustum& frustum :
       {Frustum{}, Frustum{0.14, 0.165, 1.05, 0.6}, Frustum{0.12, 0.22, 1.0, 0.7}}) {
    const Laid laid = lay(frustum, 0.02);
    ASSERT_EQ(laid.draped.size(), laid.pattern.flat.size());
    double distance = 0;
    const double cosine = std::sqrt(1 - frustum.slope() * frustum.slope());
    for (const Vec3& p : laid.draped)
      distance += std::abs(std::hypot(p.x(), p.z()) - frustum.radius(p.y())) * cosine /
                  static_cast<double>(laid.draped.size());
    EXPECT_LT(distance, 0.003);
    EXPECT_NEAR(mean_stretch(laid), 1.0, 0.02);
    for (const char* name : {"waist", "hem"}) {
      const double y = std::string(name) == "waist" ? frustum.waist_y : frustum.hem_y();
      for (int v : edge_named(laid.pattern, name).vertices)
        EXPECT_NEAR(laid.draped[v].y(), y, 0.02) << name;
    }
  }
}

TEST(LayOnScan, KeepsOnePlacePerParticle) {
  const Laid laid = lay(Frustum{}, 0.02);
  std::map<int, Vec3> at;
  for (std::size_t v = 0; v < laid.draped.size(); ++v) {
    const auto [it, fresh] = at.emplace(laid.pattern.particle[v], laid.draped[v]);
    EXPECT_EQ(it->second, laid.draped[v]);
  }
  EXPECT_EQ(at.size(), static_cast<std::size_t>(laid.pattern.particle_count));
}

TEST(LayOnScan, ComesOutTheSameTwice) {
  EXPECT_EQ(lay(Frustum{}, 0.02).draped, lay(Frustum{}, 0.02).draped);
}

TEST(LayOnScan, WithoutClothOrRoundsNothingMovesFar) {
  const Laid laid = lay(Frustum{}, 0.02);
  SurfaceSamples samples =
      test::limb_samples({[](double, double) { return 0.16; }, {}, {}, 0.5, 1.0, 0.02}, 52);
  EXPECT_EQ(lay_on_scan(laid.pattern, laid.placed, samples,
                        std::vector<std::uint8_t>(samples.size(), 0), {}),
            laid.placed);
}

TEST(LayOnScan, RefusesWhatDoesNotFitTogether) {
  const Laid laid = lay(Frustum{}, 0.02);
  SurfaceSamples samples =
      test::limb_samples({[](double, double) { return 0.16; }, {}, {}, 0.5, 1.0, 0.02}, 53);
  const std::vector<std::uint8_t> cloth(samples.size(), 1);
  EXPECT_THROW(lay_on_scan(laid.pattern, {}, samples, cloth, {}), InvalidInput);
  EXPECT_THROW(lay_on_scan(laid.pattern, laid.placed, samples, {}, {}), InvalidInput);
  LayOptions options;
  options.reach = 0;
  EXPECT_THROW(lay_on_scan(laid.pattern, laid.placed, samples, cloth, {}, options), InvalidInput);
  options = {};
  options.rounds = -1;
  EXPECT_THROW(lay_on_scan(laid.pattern, laid.placed, samples, cloth, {}, options), InvalidInput);
}

}  // namespace
}  // namespace regarment
