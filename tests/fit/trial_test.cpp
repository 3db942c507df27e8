#include "fit/trial.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "made_skirts.h"

namespace regarment {
namespace {

constexpr double kEdge = 0.045;  // m, of the pattern's triangles
const std::vector<HeldEdge> kFree;

/// A straight skirt on a pillar longer than any skirt tried.
class TrialOnPillar : public testing::Test {
 protected:
  TrialOnPillar()
      : garment_(find_template("skirt")),
        pattern_(make_pattern(garment_, with_length(0.5), kEdge)),
        placed_(on(0.5).wear(pattern_)),
        target_(on(kPillar).surface(96, 48), {}, 0, kSize) {}

  static constexpr int kSize = 128;                      // pixels
  static constexpr double kGirth = 0.96, kPillar = 1.2;  // m

  static test::MadeSkirt on(double length) { return {kGirth, kGirth, length, 1.0}; }
  static Dimensions with_length(double length) { return on(length).dimensions(); }
  /// A trial of a skirt that starts where it fits, without a fold.
  Trial laid_on(double length) const {
    const Pattern pattern = make_pattern(garment_, with_length(length), kEdge);
    return {garment_, pattern, on(length).wear(pattern), target_, kFree, {}};
  }
  Trial new_trial() const { return {garment_, pattern_, placed_, target_, kFree, {}}; }

  GarmentTemplate garment_;
  Pattern pattern_;
  std::vector<Vec3> placed_;
  FitTarget target_;
};

void expect_same(const ErrorTerms& a, const ErrorTerms& b) {
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.stretch, b.stretch);
  EXPECT_EQ(a.silhouette, b.silhouette);
}

TEST_F(TrialOnPillar, TheSameStartGivesTheSameTerms) {
  Trial first = new_trial(), second = new_trial();
  const std::vector<Vec3> start = first.cloth().positions;
  const Dimensions larger = on(0.55).dimensions();
  const ErrorTerms once = first.judge(larger);
  expect_same(second.judge(larger), once);
  EXPECT_EQ(first.cloth().positions, second.cloth().positions);
  // Again in the same trial, after another garment.
  first.judge(with_length(0.4));
  first.start_from(start);
  expect_same(first.judge(larger), once);
  EXPECT_EQ(first.cloth().positions, second.cloth().positions);
}

TEST_F(TrialOnPillar, ASkirtThatFitsRestsOnThePillar) {
  Trial trial = new_trial();
  const ErrorTerms terms = trial.judge(with_length(0.5));
  EXPECT_EQ(trial.outcome().ending, DrapeEnding::CameToRest);
  EXPECT_LT(terms.distance, 0.001);  // m; particles lie on it, sides of triangles cut inside
  // Sides of 4.5 cm as chords of a circle of 15.3 cm are (l / r)^2 / 24 = 0.4 % shorter than flat.
  EXPECT_NEAR(terms.stretch, 1, 0.004);
  EXPECT_EQ(terms.distance, trial.outcome().mean_distance);
  EXPECT_EQ(terms.stretch, trial.outcome().mean_stretch);
}

TEST_F(TrialOnPillar, TheSilhouetteTermIsWhatIsLeftUncoveredOverTheSkirt) {
  for (const double length : {0.35, 0.5, 0.7}) {
    Trial trial = laid_on(length);
    // From each side the pillar shows 1.2 m, the skirt on it its length. Half a pixel of 1.3 cm at
    // the edges, and the skirt's sides being chords, make up to a tenth of that.
    const double expected = 4 * (kPillar - length) / length;
    EXPECT_NEAR(trial.judge(with_length(length)).silhouette, expected, 0.1 * expected) << length;
  }
}

TEST_F(TrialOnPillar, ALongerSkirtShowsALargerSilhouette) {
  std::size_t last = 0;
  for (const double length : {0.3, 0.4, 0.5, 0.6}) {
    Trial trial = laid_on(length);
    trial.judge(with_length(length));
    SilhouetteRenderer renderer(trial.cloth().triangles, trial.cloth().size(), kSize);
    const std::size_t area =
        renderer.draw(trial.cloth().positions, target_.cameras()).front().area();
    EXPECT_GT(area, last) << length;
    last = area;
  }
}

TEST_F(TrialOnPillar, ATooNarrowSkirtIsStretched) {
  const test::MadeSkirt narrow{0.9 * kGirth, 0.9 * kGirth, 0.5, 1.0};
  Trial trial = new_trial();
  const double level = trial.judge(with_length(0.5)).stretch;
  trial.start_from(new_trial().cloth().positions);
  // A third of the springs run round the pillar and a third along it, slanted ones in between.
  EXPECT_GT(trial.judge(narrow.dimensions()).stretch, level + 0.02);
}

TEST_F(TrialOnPillar, HeldEdgesComeToLieOnTheirCurves) {
  test::MadeSkirt lower = on(0.5);
  lower.top -= 0.1;
  const std::vector<HeldEdge> held = {
      {test::edge_particles(pattern_, "waist"), lower.curve(0)},
      {test::edge_particles(pattern_, "hem"), lower.curve(lower.length)}};
  Trial trial(garment_, pattern_, placed_, target_, held, {});
  trial.judge(with_length(0.5));
  for (const HeldEdge& edge : held)
    for (const int i : edge.particles) {
      const Vec3& p = trial.cloth().positions[static_cast<std::size_t>(i)];
      EXPECT_NEAR(p.y(), edge.curve.front().y(), 0.01);  // of the 10 cm it had to go
    }
}

TEST_F(TrialOnPillar, ASkirtOutOfThePicturesIsWorseThanAnySeen) {
  Trial trial = new_trial();
  const double seen = trial.judge(with_length(0.5)).silhouette;
  std::vector<Vec3> far = trial.cloth().positions;
  for (Vec3& p : far) p.x() += 100;  // m, farther than the attraction brings it in a few steps
  DrapeOptions few;
  few.max_steps = 1;
  Trial strayed(garment_, pattern_, placed_, target_, kFree, few);
  strayed.start_from(far);
  const double unseen = strayed.judge(with_length(0.5)).silhouette;
  EXPECT_TRUE(std::isfinite(unseen));
  EXPECT_GT(unseen, seen);
}

TEST_F(TrialOnPillar, RefusesDimensionsThatMakeNoGarment) {
  Trial trial = new_trial();
  EXPECT_THROW(trial.judge(with_length(0.1)), InvalidInput);
}

}  // namespace
}  // namespace regarment
