#include "measure/section.h"

#include <gtest/gtest.h>

#include "measure/outline.h"
#include "support/closed_forms.h"
#include "support/limbs.h"

namespace regarment {
namespace {

using test::LimbPlan;

constexpr double kPi = std::numbers::pi;
// A slab of 2 mm: what of its thickness is seen in a section is far below the tolerances.
constexpr double kThin = 0.001;

LimbPlan cone(double radius_at_0, double slope) {
  LimbPlan plan;
  plan.low = 0.3, plan.high = 0.9, plan.spacing = 0.0015;
  plan.radius = [=](double s, double) { return radius_at_0 + slope * s; };
  return plan;
}

/// Points of a torus with the upright axis over the origin, its middle circle at height 0.
SurfaceSamples torus(double ring, double tube, double spacing, std::uint64_t seed) {
  test::Dice dice(seed);
  SurfaceSamples samples;
  const int rows = static_cast<int>(2 * kPi * tube / spacing),
            columns = static_cast<int>(2 * kPi * (ring + tube) / spacing);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double a = 2 * kPi * (i + dice.uniform(0, 1)) / rows,
                   b = 2 * kPi * (j + dice.uniform(0, 1)) / columns;
      const Vec3 out(std::sin(b), 0, std::cos(b));
      const Vec3 normal = std::cos(a) * out + std::sin(a) * Vec3::UnitY();
      samples.positions.push_back(ring * out + tube * normal);
      samples.normals.push_back(normal);
    }
  return samples;
}

/// The whole way round a section: two halves from angle 0 to angle pi.
double whole_way(const Section& section, double front, double back) {
  const Vec3 from = section.centre + front * section.zero,
             to = section.centre - back * section.zero;
  return section.length_between(from, to, section.centre + section.quarter) +
         section.length_between(from, to, section.centre - section.quarter);
}

TEST(Section, ArcsOfACylinderAreAngleTimesRadius) {
  const SurfaceSamples samples = test::limb_samples(cone(0.16, 0), 31);
  const Section section =
      cut_section(samples, test::all_of(samples), {0, 0.6, 0}, Vec3::UnitZ(), Vec3::UnitX(), kThin);
  const auto at = [](double phi) { return Vec3(0.16 * std::sin(phi), 0.6, 0.16 * std::cos(phi)); };
  for (const double from : {-2.5, -0.3, 1.9})
    for (const double sweep : {0.5, 1.5, 3.0, 5.5}) {
      const double to = from + sweep;
      EXPECT_NEAR(section.length_between(at(from), at(to), at(from + sweep / 2)), 0.16 * sweep,
                  0.01 * 0.16 * sweep);
      // The other way round is the rest of the circle.
      EXPECT_NEAR(section.length_between(at(from), at(to), at(from + sweep / 2 + kPi)),
                  0.16 * (2 * kPi - sweep), 0.01 * 0.16 * (2 * kPi - sweep) + 0.001);
    }
}

TEST(Section, GirthsOfAConeAreCirclesOfItsRadius) {
  const SurfaceSamples samples = test::limb_samples(cone(0.32, -0.25), 32);
  for (const double y : {0.4, 0.6, 0.8}) {
    const double radius = 0.32 - 0.25 * y;
    const Section section =
        cut_section(samples, test::all_of(samples), {0, y, 0}, Vec3::UnitZ(), Vec3::UnitX(), kThin);
    EXPECT_NEAR(whole_way(section, radius, radius), test::circle_length(radius),
                0.005 * test::circle_length(radius));
  }
}

TEST(Section, ATiltedPlaneCutsAnEllipseOutOfACylinder) {
  const SurfaceSamples samples = test::limb_samples(cone(0.12, 0), 33);
  for (const double tilt : {0.3, 0.6}) {
    const Vec3 zero(0, std::sin(tilt), std::cos(tilt));
    const Section section =
        cut_section(samples, test::all_of(samples), {0, 0.6, 0}, zero, Vec3::UnitX(), kThin);
    const double longer = 0.12 / std::cos(tilt), expected = test::ellipse_length(longer, 0.12);
    EXPECT_NEAR(whole_way(section, longer, longer), expected, 0.005 * expected);
  }
}

TEST(Section, PathsDownAConeAreItsSlant) {
  const SurfaceSamples samples = test::limb_samples(cone(0.32, -0.25), 34);
  const auto at = [](double y, double phi) {
    const double r = 0.32 - 0.25 * y;
    return Vec3(r * std::sin(phi), y, r * std::cos(phi));
  };
  const double slant = std::hypot(0.5, 0.25 * 0.5);
  for (const double phi : {0.0, 1.0, kPi}) {
    const Vec3 out(std::sin(phi), 0, std::cos(phi));
    const Section section =
        cut_section(samples, test::all_of(samples), {0, 0.6, 0}, Vec3::UnitY(), out, kThin, 240);
    EXPECT_NEAR(section.length_between(at(0.85, phi), at(0.35, phi), Vec3(0, 0.6, 0) + 0.2 * out),
                slant, 0.005 * slant);
  }
}

TEST(Section, CutsCirclesOutOfATorus) {
  const double ring = 0.2, tube = 0.06;
  const SurfaceSamples samples = torus(ring, tube, 0.0015, 35);
  // Level cuts: outside is the circle at distance ring + sqrt(tube^2 - h^2).
  for (const double h : {-0.03, 0.0, 0.04}) {
    const double radius = ring + std::sqrt(tube * tube - h * h);
    const Section section =
        cut_section(samples, test::all_of(samples), {0, h, 0}, Vec3::UnitZ(), Vec3::UnitX(), kThin);
    EXPECT_NEAR(whole_way(section, radius, radius), test::circle_length(radius),
                0.007 * test::circle_length(radius));
  }
  // Through the axis: the tube's own circle, seen from its middle.
  std::vector<int> in_front;
  for (std::size_t s = 0; s < samples.size(); ++s)
    if (samples.positions[s].z() > 0) in_front.push_back(static_cast<int>(s));
  const Section section =
      cut_section(samples, in_front, {0, 0, ring}, Vec3::UnitZ(), Vec3::UnitY(), kThin);
  EXPECT_NEAR(whole_way(section, tube, tube), test::circle_length(tube),
              0.01 * test::circle_length(tube));
}

TEST(Section, TheTapeAndTheOutlineReadTheSameGirthOfATorus) {
  const SurfaceSamples samples = torus(0.2, 0.06, 0.0015, 36);
  std::vector<Vec2> points;
  for (const Vec3& p : samples.positions)
    if (std::abs(p.y() - 0.02) < kThin) points.emplace_back(p.x(), p.z());
  const double radius = 0.2 + std::sqrt(0.06 * 0.06 - 0.02 * 0.02);
  EXPECT_NEAR(outline_length(points, Vec2::Zero()), test::circle_length(radius),
              0.01 * test::circle_length(radius));
}

TEST(Section, BridgesSmallGapsAndGivesUpOnLargeOnes) {
  LimbPlan plan = cone(0.16, 0);
  plan.missing = [](double, double phi) { return phi > 0.5 && phi < 1.5; };
  const SurfaceSamples samples = test::limb_samples(plan, 37);
  const Section section =
      cut_section(samples, test::all_of(samples), {0, 0.6, 0}, Vec3::UnitZ(), Vec3::UnitX(), kThin);
  const auto at = [](double phi) { return Vec3(0.16 * std::sin(phi), 0.6, 0.16 * std::cos(phi)); };
  // Over the gap lies its chord.
  const double expected = 0.16 * (3.0 - 1.0) + 2 * 0.16 * std::sin(0.5);
  EXPECT_NEAR(section.length_between(at(-0.5), at(2.5), at(1.0)), expected, 0.01 * expected);
  EXPECT_TRUE(std::isnan(section.length_between(at(0.4), at(1.6), at(1.0))));
  EXPECT_TRUE(std::isnan(section.r[static_cast<std::size_t>((1.0 + kPi) / (2 * kPi) * 180)]));
}

TEST(Section, AnglesAndPointsAgree) {
  Section section{Vec3(0.1, 1, -0.2), Vec3::UnitZ(), Vec3::UnitX(), std::vector<double>(72, 0.3)};
  for (int bin = 0; bin < 72; ++bin) {
    EXPECT_NEAR(section.angle_of(section.point(bin)), -kPi + (bin + 0.5) * 2 * kPi / 72, 1e-9);
    EXPECT_NEAR((section.point(bin) - section.centre).norm(), 0.3, 1e-12);
  }
}

TEST(CurveBesideEdge, OnAConeIsTheCircleJustInside) {
  const SurfaceSamples samples = test::limb_samples(cone(0.32, -0.25), 38);
  const LimbAxis axis = test::upright_axis(0.3, 0.9);
  const LimbMap map = make_limb_map(samples, test::all_of(samples), axis, 0.3, 0.9, 0.004, 144);
  FoundEdge edge;
  edge.s.assign(144, 0.5);
  edge.r.assign(144, 0.32 - 0.25 * 0.5);
  const auto girth = [&](bool above) {
    return closed_length(curve_beside_edge(samples, test::all_of(samples), axis, map, edge, above));
  };
  // Between 2 and 12 mm inside, 7 mm in the middle.
  EXPECT_NEAR(girth(true), test::circle_length(0.32 - 0.25 * 0.507), 0.006);
  EXPECT_NEAR(girth(false), test::circle_length(0.32 - 0.25 * 0.493), 0.006);
}

}  // namespace
}  // namespace regarment
