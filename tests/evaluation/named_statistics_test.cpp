#include "evaluation/named_statistics.h"

#include <gtest/gtest.h>

#include <set>

namespace regarment {
namespace {

TEST(NamedStatistics, HaveEachANameOfTheirOwn) {
  std::set<std::string_view> names;
  for (const NamedStatistic& one : named_statistics()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(one.name.find('.'), std::string_view::npos) << one.name;
  }
}

TEST(NamedStatistics, OfNothingAreCountsAndNothingElse) {
  for (const NamedStatistic& one : named_statistics()) {
    EXPECT_EQ(one.value(GroupStatistics()).value_or(0), 0) << one.name;
  }
}

TEST(Compare, KnowsWhichWayIsBetter) {
  EXPECT_EQ(compare(Better::Smaller, 2, 1), 1);
  EXPECT_EQ(compare(Better::Smaller, 1, 2), -1);
  EXPECT_EQ(compare(Better::Larger, 1, 2), 1);
  EXPECT_EQ(compare(Better::NearZero, -2, 1), 1);
  EXPECT_EQ(compare(Better::NearZero, 1, -2), -1);
  EXPECT_EQ(compare(Better::NearOne, 0.9, 1.05), 1);
  EXPECT_EQ(compare(Better::NearNinety, 1.0, 0.95), 1);
  EXPECT_EQ(compare(Better::NearNinety, 0.9, 0.8), -1);
  EXPECT_EQ(compare(Better::Neither, 1, 2), 0);
}

TEST(Compare, TakesTheLastStoredDigitForTheSame) {
  EXPECT_EQ(compare(Better::Smaller, 1, 1.0004), 0);
  EXPECT_EQ(compare(Better::Smaller, 1, 1.0006), -1);
}

}  // namespace
}  // namespace regarment
