#include <gtest/gtest.h>

#include "garment/springs.h"
#include "garment_samples.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr double kExact = 1e-9;  // m, the promise; doubles would do better
const double kPi = std::acos(-1.0);

/// Length of the polyline of all mesh edges of one panel that lie on the straight segment a b,
/// and nothing else: the pattern's own edges, found without asking it which they are.
double length_on_segment(const Pattern& pattern, int panel, const Vec2& a, const Vec2& b) {
  const Vec2 along = (b - a).normalized();
  const auto on_line = [&](const Vec2& p) {
    const Vec2 d = p - a;
    return std::abs(d.x() * along.y() - d.y() * along.x()) < 1e-9 && d.dot(along) > -1e-9 &&
           d.dot(along) < (b - a).norm() + 1e-9;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> pieces;
  for (const Triangle& t : pattern.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = t[k], j = t[(k + 1) % 3];
      if (pattern.panel[i] != panel || !on_line(pattern.flat[i]) || !on_line(pattern.flat[j]))
        continue;
      pieces[std::minmax(i, j)] = (pattern.flat[i] - pattern.flat[j]).norm();
    }
  double length = 0.0;
  for (const auto& [unused, piece] : pieces) length += piece;
  return length;
}

double total_area(const Pattern& pattern) {
  double area = 0.0;
  for (const double a : triangle_areas(pattern)) area += a;
  return area;
}

double polygon_area(const std::vector<Vec2>& p) {
  double twice = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2& next = p[(i + 1) % p.size()];
    twice += p[i].x() * next.y() - p[i].y() * next.x();
  }
  return twice / 2.0;
}

TEST(PatternLength, SkirtMeasuresItsDimensions) {
  const GarmentTemplate skirt = find_template("skirt");
  Pattern pattern = make_pattern(skirt, skirt.typical(), 0.04);
  const std::vector<Dimensions> samples = test::possible_dimensions(skirt, 100);
  ASSERT_EQ(samples.size(), 100u);
  for (const Dimensions& d : samples) {
    move_pattern(skirt, d, pattern);
    EXPECT_NEAR(loop_length(pattern, edge_named(pattern, "waist")), d.at("waist"), kExact);
    EXPECT_NEAR(loop_length(pattern, edge_named(pattern, "hem")), d.at("width"), kExact);
    const double length = d.at("length"), hip = d.at("hip") / 4.0;
    double hip_girth = 0.0;
    for (const int panel : {0, 1}) {
      EXPECT_NEAR(length_on_segment(pattern, panel, {0, 0}, {0, length}), length, kExact);
      hip_girth += length_on_segment(pattern, panel, {-hip, 0.2}, {hip, 0.2});
    }
    EXPECT_NEAR(hip_girth, d.at("hip"), kExact);
    // Two trapezoids per panel.
    const double area = (d.at("waist") + d.at("hip")) / 2.0 * 0.2 +
                        (d.at("hip") + d.at("width")) / 2.0 * (length - 0.2);
    EXPECT_NEAR(total_area(pattern), area, 1e-9);
  }
}

TEST(PatternLength, ShirtMeasuresItsDimensions) {
  const GarmentTemplate shirt = find_template("tshirt");
  Pattern pattern = make_pattern(shirt, shirt.typical(), 0.04);
  const std::vector<Dimensions> samples = test::possible_dimensions(shirt, 100);
  ASSERT_EQ(samples.size(), 100u);
  const auto panel = [&](const std::string& name) {
    return static_cast<int>(
        std::find(pattern.panel_names.begin(), pattern.panel_names.end(), name) -
        pattern.panel_names.begin());
  };
  for (const Dimensions& d : samples) {
    move_pattern(shirt, d, pattern);
    const test::ShirtPoints points(d);
    EXPECT_NEAR(loop_length(pattern, edge_named(pattern, "hem")), d.at("width"), kExact);
    for (const std::string side : {"left", "right"}) {
      const double sign = side == "left" ? 1.0 : -1.0;
      const auto on_side = [&](const Vec2& p) { return Vec2(sign * p.x(), p.y()); };
      EXPECT_NEAR(loop_length(pattern, edge_named(pattern, side + "_cuff")), d.at("sleeve_opening"),
                  kExact);
      double seam_sleeve = 0.0, seam_body = 0.0;
      for (const std::string face : {"front", "back"}) {
        const int sleeve = panel(side + "_sleeve_" + face), body = panel(face);
        const auto measured = [&](int p, const Vec2& a, const Vec2& b) {
          return length_on_segment(pattern, p, on_side(a), on_side(b));
        };
        EXPECT_NEAR(measured(sleeve, points.shoulder, points.end), d.at("sleeve_length"), kExact);
        EXPECT_NEAR(measured(body, points.neck, points.shoulder),
                    (points.shoulder - points.neck).norm(), kExact);
        seam_sleeve += measured(sleeve, points.shoulder, points.sleeve_underarm);
        seam_body += measured(body, points.shoulder, points.underarm);
        const Vec2 hem(d.at("width") / 4.0, d.at("length"));
        EXPECT_NEAR(measured(body, points.underarm, hem), hem.y() - points.underarm.y(), kExact);
      }
      EXPECT_NEAR(seam_sleeve, d.at("sleeve_seam"), kExact);
      EXPECT_NEAR(seam_body, d.at("sleeve_seam"), kExact);
    }
    // The body runs from where shoulder and neck meet, at t = 0, down to the hem.
    double lowest = 0.0, highest = 1e9;
    for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
      if (pattern.panel_limbs[static_cast<std::size_t>(pattern.panel[v])] != "torso") continue;
      lowest = std::max(lowest, pattern.flat[v].y());
      highest = std::min(highest, pattern.flat[v].y());
    }
    EXPECT_NEAR(highest, 0.0, kExact);
    EXPECT_NEAR(lowest, d.at("length"), kExact);
  }
}

TEST(PatternLength, ShirtHasItsAreaAndFixedNeck) {
  const GarmentTemplate shirt = find_template("tshirt");
  Pattern pattern = make_pattern(shirt, shirt.typical(), 0.03);
  constexpr int kNeckPieces = 12;  // of the half ellipse
  double neck = 0.0;
  for (int k = 0; k < kNeckPieces; ++k) {
    const double a = kPi * k / kNeckPieces, b = kPi * (k + 1) / kNeckPieces;
    neck += std::hypot(0.09 * (std::cos(a) - std::cos(b)), 0.07 * (std::sin(a) - std::sin(b)));
  }
  for (const Dimensions& d : test::possible_dimensions(shirt, 50)) {
    move_pattern(shirt, d, pattern);
    EXPECT_NEAR(loop_length(pattern, edge_named(pattern, "neck")), 2.0 * neck, kExact);
    const test::ShirtPoints p(d);
    // Half the body without its neck, the polygon inscribed in the ellipse, one sleeve face.
    const double body = polygon_area({{0, 0},
                                      p.neck,
                                      p.shoulder,
                                      p.underarm,
                                      {d.at("width") / 4.0, d.at("length")},
                                      {0, d.at("length")}});
    const double hole = 0.5 * kNeckPieces * 0.09 * 0.07 * std::sin(kPi / kNeckPieces);
    const double sleeve = polygon_area({p.shoulder, p.end, p.cuff, p.sleeve_underarm});
    EXPECT_NEAR(total_area(pattern), 4.0 * (body + sleeve) - 2.0 * hole, 1e-9);
  }
}

TEST(PatternLength, NeckIsTheHalfEllipse) {
  const GarmentTemplate shirt = find_template("tshirt");
  const Pattern pattern = make_pattern(shirt, shirt.typical(), 0.01);
  int corners = 0;
  for (const int v : edge_named(pattern, "neck").vertices) {
    const Vec2 p = pattern.flat[static_cast<std::size_t>(v)];
    const double level = std::pow(p.x() / 0.09, 2) + std::pow(p.y() / 0.07, 2);
    EXPECT_LE(level, 1.0 + 1e-9);
    EXPECT_GE(level, std::pow(std::cos(kPi / 24.0), 2) - 1e-9);  // middle of a piece
    EXPECT_GE(p.y(), -1e-12);
    if (std::abs(level - 1.0) < 1e-9) ++corners;
  }
  EXPECT_EQ(corners, 24);  // 12 pieces in front and 12 behind
}

}  // namespace
}  // namespace regarment
