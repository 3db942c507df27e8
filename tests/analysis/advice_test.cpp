#include "analysis/advice.h"

#include <gtest/gtest.h>

#include "analysis/analyze.h"
#include "findings.h"

namespace regarment {
namespace {

/// 1.8 m tall, levels of 1 cm, armpits at 1.32 m and arms beside the trunk.
Body plain_body() {
  Body body;
  body.height = 1.8;
  body.slice_height = 0.01;
  for (int i = 0; i < 180; ++i) {
    TrunkLevel level;
    level.y = 0.005 + 0.01 * i;
    level.present = true;
    level.left_arm_joined = level.right_arm_joined = i >= 132;
    body.trunk.push_back(level);
  }
  for (ArmAxis& arm : body.arms) arm.points = {Vec3(0.2, 1.3, 0), Vec3(0.5, 0.9, 0)};
  body.fork = 0.85;
  return body;
}

TEST(Advice, IsSilentWhenArmsAndLegsAreApart) { EXPECT_TRUE(advise(plain_body()).empty()); }

TEST(Advice, SaysWhereAnArmTouches) {
  Body body = plain_body();
  for (int i = 104; i < 118; ++i) body.trunk[static_cast<std::size_t>(i)].left_arm_joined = true;
  body.trunk[70].right_arm_joined = true;  // a centimetre is a matter of the slices
  const std::vector<Finding> findings = advise(body);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "arm_touches_torso");
  EXPECT_EQ(findings[0].severity, Severity::Advice);
  EXPECT_EQ(findings[0].found,
            "The left arm touches the torso (from 104 to 118 cm above the floor)");
  EXPECT_EQ(findings[0].advice, "Scan again with the arms held out");
}

TEST(Advice, SaysThatAnArmIsNotSeenApart) {
  Body body = plain_body();
  body.arms[1].points.clear();
  const std::vector<Finding> findings = advise(body);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].found, "The right arm is not seen apart from the torso");
}

TEST(Advice, SaysWhereLegsTouchUnlessASkirtHidesThem) {
  Body body = plain_body();
  body.fork = 0.62;
  ASSERT_EQ(advise(body).size(), 1U);
  EXPECT_EQ(advise(body)[0].code, "legs_touch");
  EXPECT_EQ(advise(body)[0].found, "The legs touch from 62 cm above the floor up");
  body.fork_is_garment = true;
  EXPECT_TRUE(advise(body).empty());
}

std::vector<std::string> codes_of(const test::PersonPlan& plan) {
  const Scan scan = test::scan_of(test::make_person(plan).mesh, plan.edge);
  std::vector<std::string> codes;
  for (const Finding& f : analyze(scan, test::templates_of({"skirt"})).scan.facts.findings) {
    codes.push_back(f.code);
  }
  return codes;
}

TEST(Advice, ReachesTheAnalysis) {
  test::PersonPlan plan;
  plan.skirt = test::MadeSkirt{};
  EXPECT_TRUE(codes_of(plan).empty());
  plan.left_arm = 0.02;  // hangs through the side of the waist
  EXPECT_EQ(codes_of(plan), std::vector<std::string>{"arm_touches_torso"});
}

}  // namespace
}  // namespace regarment
