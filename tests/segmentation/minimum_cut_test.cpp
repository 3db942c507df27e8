#include "segmentation/minimum_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "support/dice.h"

namespace regarment {
namespace {

/// Energy of a labelling as the header says it, in thousandths.
long energy(const std::vector<float>& odds, const std::vector<CutLink>& links, unsigned labels) {
  const auto label = [&](std::size_t i) { return labels >> i & 1U; };
  long sum = 0;
  for (std::size_t i = 0; i < odds.size(); ++i)
    if ((odds[i] > 0) != (label(i) == 1)) sum += std::lround(std::abs(odds[i]) * 1000);
  for (const CutLink& link : links)
    if (label(link.a) != label(link.b)) sum += std::lround(link.cost * 1000);
  return sum;
}

unsigned as_bits(const std::vector<std::uint8_t>& labels) {
  unsigned bits = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) bits |= static_cast<unsigned>(labels[i]) << i;
  return bits;
}

TEST(MinimumCut, HasTheLeastEnergyOfAllLabellings) {
  test::Dice dice(11);
  constexpr unsigned kVertices = 10;
  for (int graph = 0; graph < 60; ++graph) {
    std::vector<float> odds;
    for (unsigned i = 0; i < kVertices; ++i)
      odds.push_back(static_cast<float>(dice.uniform(-2, 2)));
    std::vector<CutLink> links;
    for (int k = 0; k < 20; ++k)  // some of a vertex with itself, some twice
      links.push_back({static_cast<std::uint32_t>(dice.uniform(0, kVertices - 1e-9)),
                       static_cast<std::uint32_t>(dice.uniform(0, kVertices - 1e-9)),
                       static_cast<float>(dice.uniform(0, 1.5))});
    const unsigned found = as_bits(minimum_cut(odds, links));
    long least = std::numeric_limits<long>::max();
    for (unsigned labels = 0; labels < 1U << kVertices; ++labels)
      least = std::min(least, energy(odds, links, labels));
    ASSERT_EQ(energy(odds, links, found), least) << graph;
  }
}

TEST(MinimumCut, PutsTheBorderWhereItIsCheapest) {
  // A chain that is cloth at one end and skin at the other: the border falls on its weak link.
  const std::vector<float> odds = {5, 0, 0, 0, 0, -5};
  const std::vector<CutLink> links = {{0, 1, 1}, {1, 2, 1}, {2, 3, 0.25F}, {3, 4, 1}, {4, 5, 1}};
  EXPECT_EQ(minimum_cut(odds, links), (std::vector<std::uint8_t>{1, 1, 1, 0, 0, 0}));
}

TEST(MinimumCut, OverrulesAVertexAmongOthers) {
  const std::vector<float> odds = {2, -1, 2};
  EXPECT_EQ(minimum_cut(odds, std::vector<CutLink>{{0, 1, 0.6F}, {1, 2, 0.6F}}),
            (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(minimum_cut(odds, std::vector<CutLink>{{0, 1, 0.4F}, {1, 2, 0.4F}}),
            (std::vector<std::uint8_t>{1, 0, 1}));
  EXPECT_EQ(minimum_cut(odds, {}), (std::vector<std::uint8_t>{1, 0, 1}));
}

TEST(MinimumCut, HasTheFewestOnesWhereSeveralAreBest) {
  EXPECT_EQ(minimum_cut(std::vector<float>{0, 0}, {}), (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(minimum_cut(std::vector<float>{1, 0, -1}, std::vector<CutLink>{{0, 1, 1}, {1, 2, 1}}),
            (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_TRUE(minimum_cut({}, {}).empty());
}

TEST(MinimumCut, RefusesWhatIsNoGraph) {
  const std::vector<float> odds = {1, -1};
  const auto refused = [&](const CutLink& link) {
    EXPECT_THROW(minimum_cut(odds, std::vector<CutLink>{link}), InvalidInput);
  };
  refused({0, 2, 1});
  refused({2, 0, 1});
  refused({0, 1, -0.5F});
  refused({0, 1, std::nanf("")});
  refused({0, 1, 20000});
  for (const float wrong : {std::nanf(""), HUGE_VALF, -20000.0F})
    EXPECT_THROW(minimum_cut(std::vector<float>{wrong}, {}), InvalidInput);
}

}  // namespace
}  // namespace regarment
