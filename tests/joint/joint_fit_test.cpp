#include "joint/joint_fit.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "joint/refine.h"
#include "rolled_skirt.h"

namespace regarment {
namespace {

const JointOptions kQuick = [] {
  JointOptions options;
  options.levels = {{0.06, 20, 0.04}, {0.04, 10, 0.02}};
  return options;
}();

JointFit fit_tube(double girth, double length, double start_girth, double start_length,
                  const JointOptions& options = kQuick) {
  const GarmentTemplate skirt = find_template("skirt");
  Dimensions start = tube_dimensions(start_girth, start_length);
  for (const auto& [name, value] : options.fixed) start[name] = value;
  const Pattern pattern = make_pattern(skirt, start, 0.05);
  return joint_fit(skirt, start, pattern,
                   rolled(pattern, start_girth, girth / (2 * std::numbers::pi) + 0.01),
                   tube_target(girth, length), {}, options, {});
}

TEST(JointFit, FindsATubeFromStartsThatAreFarOff) {
  for (const double off : {-0.08, 0.08}) {
    const JointFit fit = fit_tube(1.0, 0.6, 1.0 + off, 0.6 + off);
    EXPECT_NEAR(fit.dimensions.at("length"), 0.6, 0.003) << off;
    EXPECT_NEAR(fit.dimensions.at("width"), 1.0, 0.005) << off;
    EXPECT_NEAR(fit.dimensions.at("hip"), 1.0, 0.005) << off;
    EXPECT_NEAR(fit.dimensions.at("waist"), 1.0, 0.008) << off;
    EXPECT_GT(fit.matched, 0.95);
    EXPECT_LT(fit.surface_error, 0.002);
  }
}

// A slope below 1 would be a prior that pretends to be a measurement.
TEST(JointFit, FollowsTheSizeOneToOne) {
  const JointFit small = fit_tube(0.9, 0.5, 1.0, 0.55), large = fit_tube(1.1, 0.6, 1.0, 0.55);
  EXPECT_NEAR((large.dimensions.at("hip") - small.dimensions.at("hip")) / 0.2, 1, 0.02);
  EXPECT_NEAR((large.dimensions.at("length") - small.dimensions.at("length")) / 0.1, 1, 0.03);
}

TEST(JointFit, HoldsWhatIsKnown) {
  JointOptions options = kQuick;
  options.fixed = {{"length", 0.57}};
  const JointFit fit = fit_tube(1.0, 0.6, 1.05, 0.57, options);
  EXPECT_EQ(fit.dimensions.at("length"), 0.57);
  EXPECT_NEAR(fit.dimensions.at("hip"), 1.0, 0.02);
}

TEST(JointFit, GivesTheSameBytesTwice) {
  const JointFit a = fit_tube(1.0, 0.6, 1.05, 0.62), b = fit_tube(1.0, 0.6, 1.05, 0.62);
  EXPECT_EQ(a.dimensions, b.dimensions);
  EXPECT_EQ(a.draped, b.draped);
}

TEST(JointFit, StopsWhenAsked) {
  const Progress progress([](std::string_view, double) { return false; });
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions start = tube_dimensions(1.0, 0.6);
  const Pattern pattern = make_pattern(skirt, start, 0.05);
  EXPECT_THROW(joint_fit(skirt, start, pattern, rolled(pattern, 1.0, 0.17), tube_target(1.0, 0.6),
                         {}, kQuick, progress),
               Stopped);
}

TEST(JointFit, RefusesWhatDoesNotBelongTogether) {
  const GarmentTemplate skirt = find_template("skirt");
  const Dimensions start = tube_dimensions(1.0, 0.6);
  const Pattern pattern = make_pattern(skirt, start, 0.05);
  EXPECT_THROW(joint_fit(skirt, start, pattern, {}, tube_target(1.0, 0.6), {}, kQuick, {}),
               InvalidInput);
  JointOptions none = kQuick;
  none.levels.clear();
  EXPECT_THROW(none.check(), InvalidInput);
}

TEST(Refine, KeepsWhatIsLinear) {
  const GarmentTemplate shirt = find_template("tshirt");
  const Pattern coarse = make_pattern(shirt, shirt.typical(), 0.06);
  const Pattern fine = make_pattern(shirt, shirt.typical(), 0.03);
  const auto place = [](const Pattern& pattern) {
    std::vector<Vec3> x(pattern.particle_count);
    for (std::size_t v = 0; v < pattern.flat.size(); ++v)
      x[pattern.particle[v]] = Vec3(pattern.flat[v].x(), 2 * pattern.flat[v].y(),
                                    pattern.flat[v].x() + pattern.flat[v].y());
    return x;
  };
  const std::vector<Vec3> found = refine(coarse, place(coarse), fine), wanted = place(fine);
  double worst = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    worst = std::max(worst, (found[i] - wanted[i]).norm());
  EXPECT_LT(worst, 1e-3);  // the neckline's chords differ between both meshes
}

}  // namespace
}  // namespace regarment
