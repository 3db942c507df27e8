#include "measure/hanging_folds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measure/garment_edges.h"
#include "measure/garment_region.h"
#include "support/limbs.h"

namespace regarment {
namespace {

constexpr double kHem = 0.6, kRadius = 0.18, kLeg = 0.17;  // m
constexpr double kTip = 0.32, kDroop = 0.1;                // m, how far out and down the fold hangs
constexpr double kStep = 0.004, kPi = std::numbers::pi;

/// A fold at the person's left as two sheets 8 mm apart, whose rim falls evenly from the hem to the
/// tip; the trunk's cloth is a cylinder, the legs a narrower one down to the floor.
struct Folded {
  SurfaceSamples samples;
  Body body;
  LimbView view{test::upright_axis(0.0, 1.6), {}, {}};
  GarmentEdge hem;

  explicit Folded(bool fold) {
    for (double y = 0.02; y < 1.0; y += kStep)
      for (double phi = -kPi; phi < kPi; phi += kStep / kRadius) {
        const Vec3 out(std::sin(phi), 0, std::cos(phi));
        add((y > kHem ? kRadius : kLeg) * out + Vec3(0, y, 0), out);
      }
    for (double x = kRadius; fold && x < kTip; x += kStep)
      for (double y = rim(x); y < 0.8; y += kStep)
        for (const double side : {-1.0, 1.0}) add({x, y, 0.004 * side}, {0, 0, side});
    view.members = test::all_of(samples);
    view.map = make_limb_map(samples, view.members, view.axis, 0.0, 1.5, 0.004, 144, 0.5);
    body.height = 1.7;
    body.part.assign(samples.size(), BodyPart::Trunk);
    hem.limb = "torso", hem.garment_above = true;
    hem.found.s.assign(144, kHem), hem.found.r.assign(144, kRadius);
  }
  static double rim(double x) { return kHem - kDroop * (x - kRadius) / (kTip - kRadius); }
  void add(const Vec3& p, const Vec3& normal) {
    samples.positions.push_back(p), samples.normals.push_back(normal);
    samples.areas.push_back(kStep * kStep), samples.vertex.push_back(0);
    samples.spacing = kStep;
  }
  HangingFolds folds() const { return find_hanging_folds(samples, body, view, hem, {}, 1.0); }
  int column(double phi) const { return static_cast<int>((phi + kPi) / (2 * kPi) * 144); }
};

TEST(HangingFolds, ReachDownToTheirRim) {
  const Folded made(true);
  const HangingFolds folds = made.folds();
  ASSERT_FALSE(folds.empty());
  for (const double x : {0.235, 0.265, 0.295}) {
    // A cell is 1 cm long: the rim falls by 7 mm in it, and samples lie 4 mm apart.
    EXPECT_NEAR(folds.at(made.column(kPi / 2 + 0.01), x), Folded::rim(x), 0.008) << x;
  }
  EXPECT_TRUE(std::isnan(folds.at(made.column(0.0), 0.25)));
  EXPECT_TRUE(std::isnan(folds.at(made.column(kPi / 2), kTip + 0.03)));
}

TEST(HangingFolds, AreNotSeenWhereLegsGoOn) { EXPECT_TRUE(Folded(false).folds().empty()); }

TEST(HangingFolds, OfAnotherGarmentAreLeftOut) {
  const Folded made(true);
  const std::vector<std::uint8_t> taken(made.samples.size(), 1);
  EXPECT_TRUE(find_hanging_folds(made.samples, made.body, made.view, made.hem, taken, 1.0).empty());
}

TEST(EdgeCurve, GoesOutAndBackAlongAFold) {
  Folded made(true);
  const double level = closed_length(edge_curve(made.hem, made.view), 0);
  EXPECT_NEAR(level, 2 * kPi * kRadius, 1e-3);  // a polygon of 144 corners
  made.hem.folds = made.folds();
  const double fold = 2 * std::hypot(kTip - kRadius, kDroop);
  // Up to two cells of the way out are the hem's, and one is the tip's middle.
  EXPECT_NEAR(closed_length(edge_curve(made.hem, made.view), 0), level + fold, 0.1 * fold);
}

TEST(GarmentRegion, HoldsFoldsAndNoLegs) {
  Folded made(true);
  made.hem.folds = made.folds();
  GarmentEdges edges;
  edges.limbs.emplace("torso", made.view);
  edges.edges.emplace("hem", made.hem);
  const GarmentRegion region(edges, made.body);
  const double x = 0.28;
  for (const BodyPart part : {BodyPart::Trunk, BodyPart::Loose}) {
    EXPECT_GT(region.depth({x, Folded::rim(x) + 0.02, 0.004}, part), 0);
    EXPECT_LT(region.depth({x, Folded::rim(x) - 0.02, 0.004}, part), 0);
  }
  EXPECT_LT(region.depth({kLeg, kHem - 0.03, 0}, BodyPart::Trunk), 0);
}

}  // namespace
}  // namespace regarment
