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

/// Odds that speak for labels by `strength`.
std::vector<float> odds_for(const std::vector<std::uint8_t>& label, float strength) {
  std::vector<float> odds;
  for (const std::uint8_t l : label) odds.push_back(l ? strength : -strength);
  return odds;
}

TEST(RemoveIslands, GivesSmallPiecesToTheirSurroundings) {
  std::vector<std::uint8_t> label = {0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 1, 0, 1, 1, 1};
  remove_islands(strip(16), odds_for(label, 1), 3, 1.5, label);
  EXPECT_EQ(label, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(RemoveIslands, KeepsPiecesThatTheEvidenceSpeaksFor) {
  const std::vector<std::uint8_t> island = {0, 0, 0, 1, 1, 0, 0, 0};
  std::vector<float> odds = odds_for(island, 1);
  odds[3] = 3;  // 2 on average
  std::vector<std::uint8_t> label = island;
  remove_islands(strip(8), odds, 3, 1.5, label);
  EXPECT_EQ(label, island);
  odds[4] = -1;
  remove_islands(strip(8), odds, 3, 1.5, label);
  EXPECT_EQ(label, std::vector<std::uint8_t>(8, 0));
}

TEST(RemoveIslands, LeavesWhatNothingSurrounds) {
  std::vector<std::uint8_t> label = {0, 1, 0};
  remove_islands({}, odds_for(label, 0), 10, 1.5, label);
  EXPECT_EQ(label, (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(RemoveIslands, RefusesWhatDoesNotFit) {
  std::vector<std::uint8_t> label = {0, 1};
  EXPECT_THROW(remove_islands({}, std::vector<float>(3, 1), 1, 1, label), InvalidInput);
  EXPECT_THROW(remove_islands(strip(3), std::vector<float>(2, 1), 1, 1, label), InvalidInput);
}

}  // namespace
}  // namespace regarment
