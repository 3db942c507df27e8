#include "report/label_score.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "report/files.h"
#include "support/folders.h"

namespace regarment {
namespace {

using Labels = std::vector<std::uint8_t>;

TEST(LabelScore, PerfectLabelsScoreOne) {
  const LabelScore score = score_labels({0, 1, 1, 2}, {0, 1, 1, 2}, 2);
  EXPECT_DOUBLE_EQ(score.accuracy, 1.0);
  EXPECT_DOUBLE_EQ(score.mean_iou, 1.0);
}

// By hand: person 2 of {0,1,2} common, either 3 -> 2/3; garment 1 of either 2 -> 1/2.
TEST(LabelScore, CountsOverlapsAndSkips255) {
  const LabelScore score = score_labels({0, 0, 0, 1, 1}, {0, 0, 1, 1, 255}, 1);
  EXPECT_EQ(score.scored, 4u);
  EXPECT_DOUBLE_EQ(score.accuracy, 0.75);
  EXPECT_DOUBLE_EQ(*score.iou[0], 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(*score.iou[1], 0.5);
  EXPECT_DOUBLE_EQ(score.mean_iou, (2.0 / 3.0 + 0.5) / 2.0);
}

TEST(LabelScore, AClassThatIsNowhereHasNoOverlap) {
  const LabelScore score = score_labels({0, 1}, {0, 1}, 2);
  EXPECT_FALSE(score.iou[2].has_value());
  EXPECT_DOUBLE_EQ(score.mean_iou, 1.0);
}

TEST(LabelScore, RefusesUnknownTruthAndNothingToScore) {
  EXPECT_THROW(score_labels({0, 1}, {0, 2}, 1), ReadError);
  EXPECT_THROW(score_labels({0, 1}, {255, 255}, 1), ReadError);
  EXPECT_THROW(score_labels({0}, {0, 1}, 1), InvalidInput);
}

TEST(ReadLabels, TakesOneBytePerVertexAndNothingElse) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "l.u8";
  write_file(file, std::string_view("\0\1\2", 3));
  EXPECT_EQ(read_labels(file, 3), (Labels{0, 1, 2}));
  EXPECT_THROW(read_labels(file, 2), ReadError);
  EXPECT_THROW(read_labels(file, 4), ReadError);
  EXPECT_THROW(read_labels(folder.path(), 4), ReadError);
  EXPECT_THROW(read_labels(folder.path() / "none", 4), ReadError);
}

}  // namespace
}  // namespace regarment
