#include "render/smooth_normals.h"

#include <gtest/gtest.h>

#include "render/fill_holes.h"

namespace regarment {
namespace {

// A sheet at depth 0, all covered, normals towards the viewer.
GeometryBuffers sheet(int width, int height) {
  GeometryBuffers buffers;
  buffers.width = width, buffers.height = height;
  const auto count = std::size_t(width) * std::size_t(height);
  buffers.id.assign(count, 1);
  buffers.depth.assign(count, 0.0F);
  buffers.normal.assign(count, {0, 0});
  return buffers;
}

TEST(SmoothNormals, LeaveAnEvenSheetAsItIs) {
  GeometryBuffers buffers = sheet(40, 50);
  buffers.normal.assign(buffers.normal.size(), {1200, -3400});
  smooth_normals(buffers, 6.0, 0.01);
  for (const auto& n : buffers.normal) {
    EXPECT_NEAR(n[0], 1200, 4);  // each of four passes may cut off a fraction
    EXPECT_NEAR(n[1], -3400, 4);
  }
}

TEST(SmoothNormals, SpreadOnePixelAlikeAcrossAndDown) {
  GeometryBuffers buffers = sheet(41, 41);
  buffers.normal[buffers.index(20, 20)] = {30000, 0};
  smooth_normals(buffers, 6.0, 0.01);
  EXPECT_GT(buffers.normal[buffers.index(22, 20)][0], 100);
  EXPECT_EQ(buffers.normal[buffers.index(30, 20)][0], 0);
  for (int d = 0; d < 10; ++d) {
    EXPECT_NEAR(buffers.normal[buffers.index(20 + d, 20)][0],
                buffers.normal[buffers.index(20, 20 + d)][0], 4);
    EXPECT_EQ(buffers.normal[buffers.index(20 + d, 20)][0],
              buffers.normal[buffers.index(20 - d, 20)][0]);
  }
}

TEST(SmoothNormals, StopAtAStepInDepth) {
  GeometryBuffers buffers = sheet(40, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 20; x < 40; ++x) {
      buffers.depth[buffers.index(x, y)] = 0.1F;
      buffers.normal[buffers.index(x, y)] = {20000, 0};
    }
  }
  smooth_normals(buffers, 10.0, 0.05);
  EXPECT_EQ(buffers.normal[buffers.index(19, 10)][0], 0);
  EXPECT_NEAR(buffers.normal[buffers.index(20, 10)][0], 20000, 4);
}

TEST(FillHoles, ClosesASmallHoleFromItsNearestNeighbour) {
  GeometryBuffers buffers = sheet(20, 20);
  buffers.id[buffers.index(8, 9)] = 0;
  buffers.id[buffers.index(9, 9)] = 0;
  buffers.id[buffers.index(7, 9)] = 77;
  fill_holes(buffers, 4, 0.01);
  EXPECT_EQ(buffers.id[buffers.index(8, 9)], 77U);
  EXPECT_NE(buffers.id[buffers.index(9, 9)], 0U);
}

TEST(FillHoles, LeavesNotchesLargeHolesAndStepsAlone) {
  GeometryBuffers notch = sheet(20, 20);
  for (int y = 0; y < 10; ++y) notch.id[notch.index(10, y)] = 0;  // open at the top
  fill_holes(notch, 4, 0.01);
  EXPECT_EQ(notch.id[notch.index(10, 5)], 0U);

  GeometryBuffers large = sheet(20, 20);
  for (int y = 5; y < 12; ++y) {
    for (int x = 5; x < 12; ++x) large.id[large.index(x, y)] = 0;
  }
  fill_holes(large, 4, 0.01);
  EXPECT_EQ(large.id[large.index(8, 8)], 0U);

  GeometryBuffers step = sheet(20, 20);  // an arm in front of a body, the wall seen between them
  step.id[step.index(10, 10)] = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 11; x < 20; ++x) step.depth[step.index(x, y)] = 0.2F;
  }
  fill_holes(step, 4, 0.01);
  EXPECT_EQ(step.id[step.index(10, 10)], 0U);
}

}  // namespace
}  // namespace regarment
