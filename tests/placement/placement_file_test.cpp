#include "placement/placement_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "support/folders.h"

namespace regarment {
namespace {

std::filesystem::path write(const TemporaryFolder& folder, const std::string& text) {
  const std::filesystem::path path = folder.path() / "by-hand.json";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

TEST(PlacementFile, GivesWhatItSaysInMetres) {
  const TemporaryFolder folder;
  const PlacementOverrides read = read_placement(write(folder, R"({
    "format": "regarment.placement/1",
    "landmarks_cm": {"crotch": 78, "left_armpit": 128.5, "right_armpit": 127, "shoulder": 140, "neck": 149},
    "edges_cm": {"waist": 101, "hem": 48.25}})"));
  EXPECT_EQ(read.landmarks.size(), 5U);
  EXPECT_DOUBLE_EQ(read.landmarks.at("left_armpit"), 1.285);
  EXPECT_EQ(read.edges.size(), 2U);
  EXPECT_DOUBLE_EQ(read.edges.at("hem"), 0.4825);
}

TEST(PlacementFile, LandmarksReplaceThoseFoundAndLeaveTheRest) {
  const TemporaryFolder folder;
  Body body;
  body.fork = 0.8, body.neck = 1.5, body.shoulder = 1.4, body.armpit = {1.3, 1.31};
  apply_landmarks(read_placement(write(folder, R"({"format": "regarment.placement/1",
    "landmarks_cm": {"crotch": 75, "right_armpit": 122, "neck": 148}})")),
                  body);
  EXPECT_DOUBLE_EQ(body.fork, 0.75);
  EXPECT_DOUBLE_EQ(body.neck, 1.48);
  EXPECT_DOUBLE_EQ(body.shoulder, 1.4);
  EXPECT_DOUBLE_EQ(body.armpit[0], 1.3);
  EXPECT_DOUBLE_EQ(body.armpit[1], 1.22);
}

TEST(PlacementFile, MaySayNothing) {
  const TemporaryFolder folder;
  const PlacementOverrides read =
      read_placement(write(folder, R"({"format": "regarment.placement/1"})"));
  EXPECT_TRUE(read.landmarks.empty());
  EXPECT_TRUE(read.edges.empty());
}

struct BadPlacement {
  const char* what;
  std::string text;
  const char* expected;  // part of the message
};

std::vector<BadPlacement> bad_placements() {
  const auto with = [](const std::string& rest) {
    return R"({"format": "regarment.placement/1", )" + rest + "}";
  };
  std::string deep = with("\"edges_cm\": ");
  deep.insert(deep.size() - 1, std::string(100'000, '[') + std::string(100'000, ']'));
  return {
      {"empty", "", "JSON object"},
      {"no JSON", "waist = 101", "JSON object"},
      {"cut off", R"({"format": "regarment.placement/1", "edges_cm": {"waist": 1)", "JSON object"},
      {"an array", "[1, 2]", "JSON object"},
      {"a number", "7", "JSON object"},
      {"nested too deeply", deep, "by-hand.json"},
      {"bytes that are no text", "{\"format\": \"\xff\xfe\"}", "by-hand.json"},
      {"no format", R"({"edges_cm": {"waist": 101}})", "format"},
      {"another format", R"({"format": "regarment.placement/9"})", "format"},
      {"format of another type", R"({"format": 1})", "format"},
      {"unknown field", with(R"("edges_mm": {"waist": 1010})"), "edges_mm"},
      {"line break in a field", with(R"("a\nb": 1)"), "unknown field"},
      {"landmarks as array", with(R"("landmarks_cm": [1])"), "landmarks_cm"},
      {"edges as number", with(R"("edges_cm": 101)"), "edges_cm"},
      {"unknown landmark", with(R"("landmarks_cm": {"knee": 50})"), "knee"},
      {"height as text", with(R"("edges_cm": {"waist": "101"})"), "edges_cm.waist"},
      {"height null", with(R"("edges_cm": {"waist": null})"), "edges_cm.waist"},
      {"height true", with(R"("landmarks_cm": {"neck": true})"), "landmarks_cm.neck"},
      {"height zero", with(R"("edges_cm": {"waist": 0})"), "300 cm"},
      {"height negative", with(R"("edges_cm": {"waist": -10})"), "300 cm"},
      {"height in mm", with(R"("edges_cm": {"waist": 1010})"), "300 cm"},
      {"height out of range of numbers", with(R"("edges_cm": {"waist": 1e999})"), "by-hand.json"},
      {"line break in a name", with(R"("edges_cm": {"wa\nist": -1})"), "300 cm"},
      {"rest after the end", R"({"format": "regarment.placement/1"} {})", "JSON object"},
  };
}

TEST(PlacementFile, RefusesBadFilesInOneLineThatSaysWhere) {
  const TemporaryFolder folder;
  for (const BadPlacement& bad : bad_placements()) {
    try {
      read_placement(write(folder, bad.text));
      ADD_FAILURE() << bad.what << " was read";
    } catch (const ReadError& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.exit_status(), 3) << bad.what;
      EXPECT_EQ(message.find('\n'), std::string::npos) << bad.what;
      EXPECT_NE(message.find(bad.expected), std::string::npos) << bad.what << ": " << message;
      EXPECT_EQ(message.rfind("by-hand.json: ", 0), 0U) << bad.what << ": " << message;
      EXPECT_LT(message.size(), 300U) << bad.what;
    }
  }
}

TEST(PlacementFile, RefusesWhatIsNoFileAndWhatIsTooLarge) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_placement(folder.path()), ReadError);
  EXPECT_THROW(read_placement(folder.path() / "missing.json"), ReadError);
  const std::string large =
      R"({"format": "regarment.placement/1")" + std::string(2 << 20, ' ') + "}";
  EXPECT_THROW(read_placement(write(folder, large)), ReadError);
}

}  // namespace
}  // namespace regarment
