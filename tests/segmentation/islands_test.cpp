#include "segmentation/islands.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

/// A strip of vertices, each linked with the next.
std::vector<CutLink> strip(std::uint32_t vertices) {
  std::vector<CutLink> links;
  for (std::uint32_t v = 0; v + 1 < vertices; ++v) links.push_back({v, v + 1, 1});
  return links;
}

TEST(RemoveIslands, GivesSmallPiecesToTheirSurroundings) {
  std::vector<std::uint8_t> label = {0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 1, 0, 1, 1, 1};
  remove_islands(strip(16), std::vector<std::uint8_t>(16, 1), 3, label);
  EXPECT_EQ(label, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(RemoveIslands, KeepsPiecesThatAreMostlyBeyondDoubt) {
  std::vector<std::uint8_t> label = {0, 0, 0, 1, 1, 0, 0, 0};
  remove_islands(strip(8), std::vector<std::uint8_t>{0, 0, 0, 1, 0, 0, 0, 0}, 3, label);
  EXPECT_EQ(label, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 0, 0, 0}));
}

TEST(RemoveIslands, LeavesWhatNothingSurrounds) {
  std::vector<std::uint8_t> label = {0, 1, 0};
  remove_islands({}, std::vector<std::uint8_t>(3, 1), 10, label);
  EXPECT_EQ(label, (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(RemoveIslands, RefusesWhatDoesNotFit) {
  std::vector<std::uint8_t> label = {0, 1};
  EXPECT_THROW(remove_islands({}, std::vector<std::uint8_t>(3, 1), 1, label), InvalidInput);
  EXPECT_THROW(remove_islands(strip(3), std::vector<std::uint8_t>(2, 1), 1, label), InvalidInput);
}

}  // namespace
}  // namespace regarment
