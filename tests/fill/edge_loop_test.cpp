#include "fill/edge_loop.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

const std::vector<Vec3> kSquare = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

TEST(EdgeLoop, IsMeasuredAlongItsClosedLength) {
  const EdgeLoop loop(kSquare);
  EXPECT_DOUBLE_EQ(loop.length(), 8);
  EXPECT_EQ(loop.at(1), Vec3(1, 0, 0));
  EXPECT_EQ(loop.at(7), Vec3(0, 1, 0));
  EXPECT_EQ(loop.at(-1), loop.at(7));
  EXPECT_EQ(loop.at(8), Vec3(0, 0, 0));
}

TEST(EdgeLoop, FindsThePlaceNearest) {
  const EdgeLoop::Place place = EdgeLoop(kSquare).nearest({3, 1.5, 4});
  EXPECT_DOUBLE_EQ(place.along, 3.5);
  EXPECT_DOUBLE_EQ(place.distance, std::sqrt(17.0));
}

TEST(EdgeLoop, TellsWhatLiesAheadAndWhichWayIsShorter) {
  const EdgeLoop loop(kSquare);
  EXPECT_DOUBLE_EQ(loop.ahead(7, 1), 2);
  EXPECT_DOUBLE_EQ(loop.ahead(1, 7), 6);
  EXPECT_DOUBLE_EQ(loop.step(7, 1), 2);
  EXPECT_DOUBLE_EQ(loop.step(1, 7), -2);
}

TEST(EdgeLoop, OfOnePointHasNoLength) {
  const EdgeLoop loop({Vec3(1, 2, 3)});
  EXPECT_EQ(loop.length(), 0);
  EXPECT_EQ(loop.at(5), Vec3(1, 2, 3));
  EXPECT_EQ(loop.nearest(Vec3(1, 2, 4)).distance, 1);
  EXPECT_THROW(EdgeLoop({}), InvalidInput);
}

}  // namespace
}  // namespace regarment
