#include "render/strokes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace regarment {
namespace {

/// Looks along -z at a metre square, 100 pixels wide.
Camera camera() {
  return frame_views({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, std::vector<View>{View::Front},
                     {100, 100, 0.0})
      .front();
}

/// The rows of a picture in which something lies everywhere at `depth` (m).
std::vector<PaintRow> rows_at(float depth) {
  std::vector<PaintRow> rows(100);
  for (int y = 0; y < 100; ++y) {
    rows[std::size_t(y)].y = y;
    rows[std::size_t(y)].colour.resize(100);
    rows[std::size_t(y)].depth.assign(100, depth);
  }
  return rows;
}

std::vector<PaintRow> drawn(const std::vector<Vec3>& curve, float depth, double half_width = 1.6) {
  std::vector<PaintRow> rows = rows_at(depth);
  const Strokes strokes({curve}, camera(), half_width);
  for (PaintRow& row : rows) strokes.paint(row);
  return rows;
}

int painted(const std::vector<PaintRow>& rows) {
  int count = 0;
  for (const PaintRow& row : rows)
    for (const Linear& colour : row.colour) count += colour.a > 0 ? 1 : 0;
  return count;
}

TEST(Strokes, AnUprightLineIsAsWideAsAsked) {
  const auto rows = drawn({{0.1, -0.2, 0}, {0.1, 0.2, 0}}, 1);
  for (int y = 32; y < 68; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool near = std::abs(x + 0.5 - 60) < 1.6;
      EXPECT_EQ(rows[std::size_t(y)].colour[std::size_t(x)].a > 0, near) << x << ", " << y;
    }
  }
  EXPECT_EQ(painted({rows[25], rows[75]}), 0);  // the line is 40 pixels long
}

TEST(Strokes, ACurveIsClosed) {
  const auto rows = drawn({{-0.3, -0.3, 0}, {0.3, -0.3, 0}, {0.3, 0.3, 0}, {-0.3, 0.3, 0}}, 1);
  EXPECT_GT(rows[50].colour[20].a, 0.0F);  // the side from the last point to the first
  EXPECT_GT(rows[50].colour[79].a, 0.0F);
  EXPECT_EQ(rows[50].colour[50].a, 0.0F);
}

TEST(Strokes, IsHiddenBehindWhatStandsInFront) {
  const std::vector<Vec3> curve = {{-0.2, 0, 0}, {0.2, 0, 0}};
  EXPECT_GT(painted(drawn(curve, 0.1F)), 0);
  EXPECT_GT(painted(drawn(curve, -0.01F)), 0);  // a centimetre inside of its own surface
  EXPECT_EQ(painted(drawn(curve, -0.1F)), 0);
  EXPECT_GT(painted(drawn(curve, std::numeric_limits<float>::infinity())), 0);
}

TEST(Strokes, KnowsThePartOfThePictureItTakes) {
  const std::vector<Vec3> curve = {{-0.2, 0.1, 0}, {0.2, 0.1, 0}};
  const Strokes strokes({curve}, camera(), 1.5);
  std::vector<PaintRow> rows = rows_at(1);
  for (PaintRow& row : rows) strokes.paint(row);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x)
      if (rows[std::size_t(y)].colour[std::size_t(x)].a > 0) {
        EXPECT_TRUE(strokes.top() <= y && y < strokes.bottom()) << y;
        EXPECT_TRUE(strokes.left() <= x && x < strokes.right()) << x;
      }
  EXPECT_LE(strokes.right() - strokes.left(), 44);
  EXPECT_LE(strokes.bottom() - strokes.top(), 5);
}

TEST(Strokes, NoCurvesAndThoseOutsideDrawNothing) {
  const Strokes none({}, camera(), 1.5);
  EXPECT_EQ(none.left(), none.right());
  EXPECT_EQ(none.top(), none.bottom());
  const std::vector<Vec3> point = {{0, 0, 0}};
  EXPECT_EQ(painted(drawn(point, 1)), 0);
  EXPECT_EQ(painted(drawn({{5, 5, 0}, {6, 7, 0}}, 1)), 0);
  EXPECT_EQ(painted(drawn({{-5, -5, 0}, {-6, -7, 0}}, 1)), 0);
}

}  // namespace
}  // namespace regarment
