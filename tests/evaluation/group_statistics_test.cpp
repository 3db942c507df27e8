#include "evaluation/group_statistics.h"

#include <gtest/gtest.h>

#include "evaluations.h"

namespace regarment {
namespace {

std::vector<std::string> keys(const std::vector<GroupStatistics>& groups) {
  std::vector<std::string> out;
  for (const GroupStatistics& group : groups) out.push_back(group.key);
  return out;
}

EvaluatedScan layered() {
  EvaluatedScan scan = skirt_scan("layered", {1, 1});
  scan.about.dimensions[1] = dimension("skirt", "hip", 94, 2);
  scan.about.damage = {"holes", "noise"};
  scan.about.kind = "cloud";
  return scan;
}

TEST(GroupStatistics, AreOfAllThenOfEachKind) {
  EXPECT_EQ(keys(group_statistics({layered(), skirt_scan("a", {0})})),
            (std::vector<std::string>{"", "skirt", "skirt.length", "inner.skirt.hip", "layer.1",
                                      "layer.2", "kind.closed", "kind.cloud", "damage.holes",
                                      "damage.noise", "damage.none"}));
}

TEST(GroupStatistics, HaveTheDimensionsOfTheirGroup) {
  const auto groups = group_statistics({skirt_scan("a", {1, -3}), skirt_scan("b", {2, 5})});
  EXPECT_NEAR(find_group(groups, "")->errors.mae_cm, 11.0 / 4, 1e-12);
  EXPECT_NEAR(find_group(groups, "skirt.length")->errors.bias_cm, 1.5, 1e-12);
  EXPECT_NEAR(find_group(groups, "skirt.width")->errors.bias_cm, 1, 1e-12);
  EXPECT_EQ(find_group(groups, "skirt.width")->scans, 2u);
}

TEST(GroupStatistics, KeepWhatIsHiddenOutOfErrors) {
  EvaluatedScan scan = skirt_scan("a", {1, 40, 50});
  scan.about.dimensions[1].observable = false;
  scan.about.dimensions[2].observable = false;
  scan.found[1]->observable = false;
  const GroupStatistics all = group_statistics({scan}).front();
  EXPECT_EQ(all.errors.n, 1u);
  EXPECT_NEAR(all.errors.worst_cm, 1, 1e-12);
  EXPECT_EQ(all.hidden, 2u);
  EXPECT_EQ(all.hidden_flagged, 1u);
  EXPECT_EQ(all.visible, 1u);
  EXPECT_EQ(all.confident_wrong, 0u);
}

TEST(GroupStatistics, CountConfidentAnswersThatAreFarOff) {
  EvaluatedScan scan = skirt_scan("a", {3.01, -3.01, 2.99, 9});
  scan.found[3]->observable = false;
  const GroupStatistics all = group_statistics({scan}).front();
  EXPECT_EQ(all.confident, 3u);
  EXPECT_EQ(all.confident_wrong, 2u);
  EXPECT_EQ(all.visible_flagged, 1u);
  EXPECT_EQ(all.errors.n, 4u);  // a wrong refusal is still an error
}

TEST(GroupStatistics, CountFailuresButMeasureNothingOfThem) {
  const GroupStatistics all = group_statistics({failed("a"), skirt_scan("b", {1, 1})}).front();
  EXPECT_EQ(all.scans, 2u);
  EXPECT_EQ(all.failures, 1u);
  EXPECT_EQ(all.errors.n, 2u);
}

TEST(GroupStatistics, JudgeByIsoOnlyOneMeasurement) {
  const auto groups = group_statistics({skirt_scan("a", {0.1, 1}), skirt_scan("b", {0.2, 1.1})});
  EXPECT_FALSE(find_group(groups, "")->iso);
  EXPECT_FALSE(find_group(groups, "skirt")->iso);
  EXPECT_EQ(find_group(groups, "skirt.length")->iso->limit_cm, 0.5);
  EXPECT_TRUE(find_group(groups, "skirt.length")->iso->within);
  EXPECT_EQ(find_group(groups, "skirt.width")->iso->limit_cm, 0.9);
  EXPECT_FALSE(find_group(groups, "skirt.width")->iso->within);
}

TEST(GroupStatistics, CompareWornAndPublishedWhereBothAreKnown) {
  EvaluatedScan scan = skirt_scan("a", {0, 0, 0});
  scan.about.dimensions[0].worn_cm = 55;
  scan.found[0]->worn_cm = 57;
  scan.about.dimensions[1].worn_cm = 111;  // not found
  scan.found[2]->worn_cm = 80;             // not known
  scan.about.dimensions[2].published_cm = 70;
  const GroupStatistics all = group_statistics({scan}).front();
  EXPECT_EQ(all.worn.n, 1u);
  EXPECT_NEAR(all.worn.bias_cm, 2, 1e-12);
  EXPECT_EQ(all.published.n, 1u);
  EXPECT_NEAR(all.published.bias_cm, -8, 1e-12);
}

TEST(GroupStatistics, CountFramesThatAreKnown) {
  EvaluatedScan right = skirt_scan("a", {0}), wrong = skirt_scan("b", {0});
  right.frame_right = true;
  wrong.frame_right = false;
  const GroupStatistics all = group_statistics({right, wrong, skirt_scan("c", {0})}).front();
  EXPECT_EQ(all.frames, 2u);
  EXPECT_EQ(all.frames_wrong, 1u);
}

TEST(GroupStatistics, AverageLabelsOverScans) {
  EvaluatedScan a = skirt_scan("a", {0}), b = a, c = a;
  a.labels = LabelAgreement{0.9, {{"person", 0.95}, {"skirt", 0.85}}, 4.0};
  b.labels = LabelAgreement{0.7, {{"person", 0.75}}, {}};
  const GroupStatistics all = group_statistics({a, b, c}).front();
  EXPECT_EQ(all.labelled, 2u);
  EXPECT_NEAR(all.miou.value(), 0.8, 1e-12);
  EXPECT_NEAR(all.border_mm.value(), 4, 1e-12);
  EXPECT_EQ(all.class_iou.size(), 2u);
  EXPECT_NEAR(all.class_iou[0].second, 0.85, 1e-12);
  EXPECT_NEAR(all.class_iou[1].second, 0.85, 1e-12);
}

}  // namespace
}  // namespace regarment
