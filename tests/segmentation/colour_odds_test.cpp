#include "segmentation/colour_odds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace regarment {
namespace {

/// 2000 vertices, half of them surely cloth; the first ten of each half are in doubt.
struct Painted {
  Scan scan;
  std::vector<float> odds;
  std::vector<std::uint8_t> skip = std::vector<std::uint8_t>(2000, 0);

  Painted(const Colour& cloth, const Colour& skin) {
    for (int v = 0; v < 2000; ++v) {
      scan.mesh.colours.push_back(v < 1000 ? cloth : skin);
      odds.push_back(v % 1000 < 10 ? 0.0F : v < 1000 ? 4.0F : -4.0F);
    }
  }
};

TEST(ColourOdds, TellVerticesInDoubtByWhatSureOnesLookLike) {
  Painted painted({20, 40, 120}, {200, 150, 130});
  painted.skip[3] = 1;
  add_colour_odds(painted.scan, painted.skip, painted.odds);
  for (int v : {0, 9}) EXPECT_GT(painted.odds[v], 2);
  for (int v : {1000, 1009}) EXPECT_LT(painted.odds[v], -2);
  EXPECT_EQ(painted.odds[3], 0);
}

TEST(ColourOdds, SayNothingWhereColoursDoNotTellThemApart) {
  for (Painted painted : {Painted({90, 90, 90}, {90, 90, 90}), Painted({}, {})}) {
    const std::vector<float> before = painted.odds;
    if (painted.scan.mesh.colours[0] == Colour{}) painted.scan.mesh.colours.clear();
    add_colour_odds(painted.scan, painted.skip, painted.odds);
    EXPECT_EQ(painted.odds, before);
  }
}

TEST(ColourOdds, SayNothingOfFewVertices) {
  Painted painted({20, 40, 120}, {200, 150, 130});
  std::fill(painted.odds.begin() + 1100, painted.odds.end(), 0.0F);
  const std::vector<float> before = painted.odds;
  add_colour_odds(painted.scan, painted.skip, painted.odds);
  EXPECT_EQ(painted.odds, before);
}

}  // namespace
}  // namespace regarment
