#include "evaluation/gate.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

GroupStatistics group(const std::string& key, double mae) {
  GroupStatistics out;
  out.key = key;
  out.errors = error_statistics({{50, 50 + mae, {}, {}}});
  return out;
}

bool passes(const std::string& gate, const std::vector<GroupStatistics>& groups) {
  return judge({parse_gate(gate)}, groups).front().passed;
}

TEST(Gate, IsReadWithOrWithoutSpaces) {
  const Gate gate = parse_gate(" inner.skirt.hip.mae_cm  <= 1.5e0 ");
  EXPECT_EQ(gate.group, "inner.skirt.hip");
  EXPECT_EQ(gate.statistic, "mae_cm");
  EXPECT_EQ(gate.comparison, "<=");
  EXPECT_EQ(gate.limit, 1.5);
  EXPECT_EQ(parse_gate("bias_cm>-0.5").limit, -0.5);
  EXPECT_EQ(parse_gate("bias_cm>-0.5").group, "");
}

TEST(Gate, RefusesWhatIsNoCondition) {
  for (const char* text :
       {"", "mae_cm", "<=1", "mae_cm<=", "mae_cm<=one", "mae_cm=1", "mae_cm<=1cm", "mad_cm<=1",
        "mae_cm<=nan", "mae_cm<=inf", "mae_cm=<1", "mae_cm<<1", "skirt.<1", ".<1", "mae_cm<1 or"}) {
    EXPECT_THROW(parse_gate(text), UsageError) << text;
  }
}

TEST(Gate, KnowsItsFourComparisons) {
  const std::vector<GroupStatistics> groups = {group("", 1.5)};
  EXPECT_TRUE(passes("mae_cm<=1.5", groups));
  EXPECT_FALSE(passes("mae_cm<1.5", groups));
  EXPECT_TRUE(passes("mae_cm>=1.5", groups));
  EXPECT_FALSE(passes("mae_cm>1.5", groups));
  EXPECT_TRUE(passes("mae_cm<1.6", groups));
  EXPECT_FALSE(passes("mae_cm>=1.6", groups));
}

TEST(Gate, LooksAtItsGroup) {
  const std::vector<GroupStatistics> groups = {group("", 1), group("skirt", 3)};
  EXPECT_TRUE(passes("mae_cm<2", groups));
  EXPECT_FALSE(passes("skirt.mae_cm<2", groups));
}

TEST(Gate, WithoutAValueHasNotPassed) {
  for (const char* text : {"coverage<=1", "coverage>=0", "kind.open.mae_cm<100"}) {
    const GateResult result = judge({parse_gate(text)}, {group("", 1)}).front();
    EXPECT_FALSE(result.passed) << text;
    EXPECT_FALSE(result.value) << text;
    EXPECT_NE(why_failed(result).find("nothing could be measured"), std::string::npos);
  }
}

TEST(Gate, MustNameAGroupThereIs) {
  const std::vector<GroupStatistics> groups = {group("", 1), group("skirt.hip", 1)};
  EXPECT_NO_THROW(check_gate_groups({parse_gate("skirt.hip.mae_cm<1")}, groups));
  EXPECT_NO_THROW(check_gate_groups({parse_gate("kind.cloud.mae_cm<1")}, groups));
  EXPECT_THROW(check_gate_groups({parse_gate("skirt.hips.mae_cm<1")}, groups), UsageError);
}

}  // namespace
}  // namespace regarment
