#include "measure/rim.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/limbs.h"

namespace regarment {
namespace {

constexpr double kEdge = 0.6, kRadius = 0.2, kRim = 0.006;  // m

/// Cloth hanging down to the edge, where it bends inwards by a quarter of a circle.
SurfaceSamples skirt(bool rimmed) {
  SurfaceSamples samples;
  const auto add = [&](double s, double r, double phi, double down) {
    const Vec3 out(std::sin(phi), 0, std::cos(phi));
    samples.positions.push_back(r * out + Vec3(0, s, 0));
    samples.normals.push_back(std::sqrt(1 - down * down) * out - Vec3(0, down, 0));
    samples.areas.push_back(4e-6);
    samples.vertex.push_back(0);
  };
  for (int j = 0; j < 720; ++j) {
    const double phi = (j + 0.5) * std::numbers::pi / 360 - std::numbers::pi;
    for (double s = kEdge + 0.0005; s < 0.7; s += 0.001) add(s, kRadius, phi, 0);
    for (double a = 0.05; rimmed && a < 1.5; a += 0.1)
      add(kEdge - kRim * std::sin(a), kRadius - kRim * (1 - std::cos(a)), phi, std::sin(a));
  }
  return samples;
}

struct Made {
  SurfaceSamples samples;
  LimbView view;
  FoundEdge edge;

  Made(bool rimmed, double found_at, double step)
      : samples(skirt(rimmed)),
        view{test::upright_axis(0.5, 0.7),
             make_limb_map(samples, test::all_of(samples), test::upright_axis(0.5, 0.7), 0.5, 0.7,
                           0.004, 144),
             test::all_of(samples)} {
    edge.s.assign(144, found_at), edge.r.assign(144, kRadius), edge.step.assign(144, step);
    edge.seen.assign(144, true);
  }
};

TEST(TrimRim, MovesADropBackToWhereTheSurfaceBends) {
  Made made(true, kEdge - kRim, 0.02);
  trim_rim(made.samples, made.view, true, made.edge);
  // The bend counts from 20 degrees on, a third of the rim below the edge; a tenth of it is left.
  for (const double s : made.edge.s) EXPECT_NEAR(s, kEdge - 0.4 * kRim, 0.0015);
}

TEST(TrimRim, LeavesStepsAndClothThatEndsSharply) {
  Made step(true, kEdge - kRim, 0.004);
  trim_rim(step.samples, step.view, true, step.edge);
  for (const double s : step.edge.s) EXPECT_EQ(s, kEdge - kRim);
  Made sharp(false, kEdge, 0.02);
  trim_rim(sharp.samples, sharp.view, true, sharp.edge);
  for (const double s : sharp.edge.s) EXPECT_EQ(s, kEdge);
}

}  // namespace
}  // namespace regarment
