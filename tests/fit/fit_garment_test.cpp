#include "fit/fit_garment.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "fit/error_terms.h"
#include "made_skirts.h"

namespace regarment {
namespace {

/// A skirt seen alone, worn without stretch, so that its true dimensions are known.
class FitMadeSkirt : public testing::Test {
 protected:
  FitMadeSkirt()
      : garment_(find_template("skirt")),
        pattern_(make_pattern(garment_, made_.dimensions(), 0.06)),
        placed_(made_.wear(pattern_, 0.02)),
        target_(made_.surface(72, 24), {}, 0, kSize) {}

  static constexpr int kSize = 128;  // pixels

  /// Ten per cent off, girths and length in other directions.
  Dimensions start() const {
    Dimensions out = made_.dimensions();
    for (auto& [name, value] : out) value *= name == "length" ? 0.9 : 1.1;
    return out;
  }
  std::vector<HeldEdge> held(double hem_lower = 0) const {
    test::MadeSkirt moved = made_;
    moved.top -= hem_lower;
    return {{test::edge_particles(pattern_, "waist"), made_.curve(0)},
            {test::edge_particles(pattern_, "hem"), moved.curve(made_.length)}};
  }
  static FitOptions few_drapes() {
    FitOptions options;
    options.search.max_evaluations = 80;
    options.rough_evaluations = 20;
    options.runs = 2;
    options.silhouette_size = kSize;
    return options;
  }
  GarmentFit fit(const FitOptions& options, const std::vector<HeldEdge>& edges,
                 const Progress& progress = {}) const {
    return fit_garment(garment_, start(), pattern_, placed_, target_, edges, options, progress);
  }

  test::MadeSkirt made_;
  GarmentTemplate garment_;
  Pattern pattern_;
  std::vector<Vec3> placed_;
  FitTarget target_;
};

/// Enough to see that everything is in its place.
FitOptions hardly_any_drapes() {
  FitOptions options;
  options.search.max_evaluations = 8;
  options.rough_evaluations = 6;
  options.runs = 2;
  return options;
}

TEST_F(FitMadeSkirt, FindsItsDimensions) {
  const GarmentFit found = fit(few_drapes(), held());
  // Sides of 6 cm are chords of the cone, by (l / r)^2 / 24 shorter than their arcs: 0.9 % at the
  // waist, 0.4 % at the hem. The search stops short of the minimum by about as much again, a fifth
  // of the 10 % it began with. Held edges give the length.
  for (const auto& [name, truth] : made_.dimensions())
    EXPECT_NEAR(found.dimensions.at(name), truth, (name == "length" ? 0.01 : 0.03) * truth) << name;
  EXPECT_NEAR(found.terms.stretch, 1, 0.005);
  ASSERT_EQ(found.draped.size(), pattern_.flat.size());
  double distance = 0;
  for (const Vec3& p : found.draped)
    distance += std::sqrt(target_.surface().closest(p).squared_distance);
  EXPECT_LT(distance / static_cast<double>(found.draped.size()), 0.002);  // m
  EXPECT_EQ(found.terms.distance, found.drape.mean_distance);
  EXPECT_EQ(found.terms.stretch, found.drape.mean_stretch);
}

TEST_F(FitMadeSkirt, TheTraceTellsTheSameAsTheResult) {
  const FitOptions options = hardly_any_drapes();
  const GarmentFit found = fit(options, held());
  const FitTrace& trace = found.trace;
  EXPECT_EQ(trace.names, (std::vector<std::string>{"length", "width", "waist", "hip"}));
  EXPECT_EQ(trace.square_root, options.square_root);
  ASSERT_EQ(trace.runs.size(), 2U);
  double smallest = std::numeric_limits<double>::infinity();
  for (const FitRun& run : trace.runs) {
    ASSERT_FALSE(run.evaluations.empty());
    EXPECT_LE(run.evaluations.size(), 8U);
    double best = std::numeric_limits<double>::infinity();
    for (const FitEvaluation& e : run.evaluations) {
      EXPECT_EQ(e.error, total_error(e.terms, trace.weights, trace.square_root));
      best = std::min(best, e.error);
      EXPECT_EQ(e.best, best);
      EXPECT_GE(e.temperature, 0);
      ASSERT_EQ(e.dimensions.size(), 4U);
      Dimensions tried;
      for (std::size_t i = 0; i < 4; ++i) tried[trace.names[i]] = e.dimensions[i];
      EXPECT_NO_THROW(garment_.check(tried));
    }
    EXPECT_EQ(run.evaluations[run.best].error, best);
    smallest = std::min(smallest, best);
  }
  const FitRun& kept = trace.runs.at(trace.best_run);
  const FitEvaluation& best = kept.evaluations[kept.best];
  EXPECT_EQ(found.error, smallest);
  EXPECT_EQ(best.error, smallest);
  EXPECT_EQ(found.terms.silhouette, best.terms.silhouette);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(found.dimensions.at(trace.names[i]), best.dimensions[i]);
}

TEST_F(FitMadeSkirt, AHeldHemThatIsWrongMovesTheLength) {
  FitOptions options = few_drapes();
  options.runs = 1;
  options.search.max_evaluations = 40;
  // The hem is said to lie 5 cm lower, where there is no scan.
  const GarmentFit found = fit(options, held(0.05));
  EXPECT_GT(found.dimensions.at("length"), made_.length + 0.03);
  EXPECT_LT(found.dimensions.at("length"), made_.length + 0.055);  // 5 cm upright, more aslant
}

void expect_same_bits(const FitTrace& a, const FitTrace& b) {
  EXPECT_EQ(a.weights.beta, b.weights.beta);
  EXPECT_EQ(a.weights.gamma, b.weights.gamma);
  EXPECT_EQ(a.best_run, b.best_run);
  ASSERT_EQ(a.runs.size(), b.runs.size());
  for (std::size_t r = 0; r < a.runs.size(); ++r) {
    const FitRun &p = a.runs[r], &q = b.runs[r];
    EXPECT_EQ(p.seed, q.seed);
    EXPECT_EQ(p.ending, q.ending);
    EXPECT_EQ(p.best, q.best);
    ASSERT_EQ(p.evaluations.size(), q.evaluations.size());
    for (std::size_t i = 0; i < p.evaluations.size(); ++i) {
      const FitEvaluation &e = p.evaluations[i], &f = q.evaluations[i];
      EXPECT_EQ(e.dimensions, f.dimensions);
      EXPECT_EQ(e.terms.distance, f.terms.distance);
      EXPECT_EQ(e.terms.stretch, f.terms.stretch);
      EXPECT_EQ(e.terms.silhouette, f.terms.silhouette);
      EXPECT_EQ(e.error, f.error);
      EXPECT_EQ(e.best, f.best);
      EXPECT_EQ(e.temperature, f.temperature);
      EXPECT_EQ(e.drape_steps, f.drape_steps);
      EXPECT_EQ(e.came_to_rest, f.came_to_rest);
    }
  }
}

TEST_F(FitMadeSkirt, TheNumberOfThreadsDoesNotMatter) {
  FitOptions options = hardly_any_drapes();
  options.threads = 1;
  const GarmentFit alone = fit(options, held());
  options.threads = 2;
  const GarmentFit together = fit(options, held());
  expect_same_bits(alone.trace, together.trace);
  EXPECT_EQ(alone.dimensions, together.dimensions);
  EXPECT_EQ(alone.error, together.error);
  EXPECT_EQ(alone.draped, together.draped);
}

TEST_F(FitMadeSkirt, ARunIsKnownByItsSeed) {
  FitOptions options = hardly_any_drapes();
  const GarmentFit two = fit(options, held());
  options.runs = 1;
  for (std::size_t r = 0; r < 2; ++r) {
    options.seed = two.trace.runs[r].seed;
    const GarmentFit alone = fit(options, held());
    ASSERT_EQ(alone.trace.runs.size(), 1U);
    const auto &a = alone.trace.runs[0].evaluations, &b = two.trace.runs[r].evaluations;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].dimensions, b[i].dimensions);
    EXPECT_EQ(alone.trace.runs[0].evaluations.back().error, b.back().error);
  }
  const auto first_tried = [&](std::size_t r) {
    return two.trace.runs[r].evaluations[0].dimensions;
  };
  EXPECT_NE(first_tried(0), first_tried(1));
}

TEST_F(FitMadeSkirt, SaysHowItGoes) {
  std::vector<std::string> details;
  double last = 0;
  fit(hardly_any_drapes(), held(),
      Progress(
          DetailedCallback([&](std::string_view stage, double fraction, std::string_view text) {
            EXPECT_EQ(stage, "fit");
            EXPECT_GE(fraction, last);
            EXPECT_LE(fraction, 1);
            last = fraction;
            details.emplace_back(text);
            return true;
          })));
  ASSERT_FALSE(details.empty());
  const auto said = [&](const char* words) {
    return std::any_of(details.begin(), details.end(),
                       [&](const std::string& d) { return d.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(said("evaluation"));
  EXPECT_TRUE(said("best error"));
  EXPECT_TRUE(said("s left"));
}

TEST_F(FitMadeSkirt, ProgressCanStopIt) {
  EXPECT_THROW(fit(hardly_any_drapes(), held(), Progress([](auto, double) { return false; })),
               Stopped);
  // Once the runs have begun, in other threads.
  FitOptions options = hardly_any_drapes();
  options.search.max_evaluations = 100'000;
  EXPECT_THROW(fit(options, held(), Progress([](auto, double fraction) { return fraction == 0; })),
               Stopped);
}

TEST_F(FitMadeSkirt, RefusesAGarmentThatIsNeverSeen) {
  FitOptions options = hardly_any_drapes();
  options.runs = 1;
  options.drape.max_steps = 1;
  placed_ = made_.wear(pattern_);
  for (Vec3& p : placed_) p.x() += 1000;  // m
  EXPECT_THROW(fit(options, {}), NoGarmentError);
}

TEST(FitOptions, NamesTheFieldThatIsOutOfRange) {
  EXPECT_NO_THROW(FitOptions{}.check());
  const auto refuses = [](const std::function<void(FitOptions&)>& spoil, const std::string& name) {
    FitOptions options;
    spoil(options);
    try {
      options.check();
      ADD_FAILURE() << name;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses([](FitOptions& o) { o.runs = 0; }, "runs");
  refuses([](FitOptions& o) { o.runs = 101; }, "runs");
  refuses([](FitOptions& o) { o.threads = -1; }, "threads");
  refuses([](FitOptions& o) { o.threads = 257; }, "threads");
  refuses([](FitOptions& o) { o.first_edge = 0; }, "first_edge");
  refuses([](FitOptions& o) { o.first_edge = 1; }, "first_edge");
  refuses([nan](FitOptions& o) { o.first_edge = nan; }, "first_edge");
  refuses([](FitOptions& o) { o.rough_evaluations = 0; }, "rough_evaluations");
  refuses([](FitOptions& o) { o.silhouette_size = 0; }, "silhouette_size");
  refuses([](FitOptions& o) { o.silhouette_size = 5000; }, "silhouette_size");
  refuses([](FitOptions& o) { o.search.cooling_share = -1; }, "cooling_share");
  refuses([nan](FitOptions& o) { o.drape.spring_stiffness = nan; }, "spring_stiffness");
}

}  // namespace
}  // namespace regarment
