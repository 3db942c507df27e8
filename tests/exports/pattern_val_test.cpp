#include "exports/pattern_val.h"

#include <gtest/gtest.h>

#include <fstream>

#include <nlohmann/json.hpp>

#include "garments.h"
#include "run_tool.h"
#include "support/folders.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

class PatternVal : public testing::Test {
 protected:
  /// Writes the pattern of this garment for Valentina.
  void write(const std::string& garment, const Dimensions& dimensions) {
    std::ofstream(file_, std::ios::binary) << pattern_val(find_template(garment), dimensions);
  }

  const TemporaryFolder home_;
  const std::string file_ = home_.path() / "pattern.val";
};

#define RUN_OR_SKIP(run, ...)               \
  const auto run = run_tool({__VA_ARGS__}); \
  if (!run) GTEST_SKIP() << run_message

constexpr const char* run_message = "valentina is not installed";

TEST_F(PatternVal, ValentinaOpensItWithoutAWarning) {
  for (const auto& [name, dimensions] :
       {std::pair("skirt", whole_skirt()), std::pair("tshirt", whole_tshirt())}) {
    write(name, dimensions);
    RUN_OR_SKIP(run, "valentina", "--test", file_);
    EXPECT_EQ(run->status, 0) << run->text;
    EXPECT_EQ(run->text.find("WARNING"), std::string::npos) << run->text;
    EXPECT_EQ(run->text.find("CRITICAL"), std::string::npos) << run->text;
  }
}

// Valentina writes its pieces as DXF, which ezdxf reads: two programs that are not ours.
TEST_F(PatternVal, ValentinaFindsTheTrueLengths) {
  write("skirt", whole_skirt());
  constexpr const char* kR12Astm = "25";
  RUN_OR_SKIP(made, "valentina", "-b", "out", "-d", home_.path().string(), "-f", kR12Astm,
              "--exportOnlyDetails", file_);
  ASSERT_EQ(made->status, 0) << made->text;
  const auto run = run_tool(
      {"/usr/bin/python3", beside_tests("read_dxf.py"), (home_.path() / "out_1.dxf").string()});
  if (!run || run->text.find("No module named") != std::string::npos)
    GTEST_SKIP() << "python3-ezdxf is not installed";
  ASSERT_EQ(run->status, 0) << run->text;
  const Json json = Json::parse(run->text);
  ASSERT_EQ(json["blocks"].size(), 2u);
  const double sides = 2.0 * (skirt_upper_side() + skirt_lower_side());
  for (const Json& block : json["blocks"]) {
    // Its outline is drawn a pixel wider, for an allowance of nothing; the sewing line is exact.
    ASSERT_EQ(block["seams"].size(), 1u);
    EXPECT_NEAR(block["seams"][0], 1000.0 * (0.36 + 0.60 + sides), 0.01);  // mm, of 2.2 m
    EXPECT_EQ(block["notches"].size(), 8u);  // four seams, hip line and fold
    EXPECT_EQ(block["grains"].size(), 1u);
  }
}

TEST_F(PatternVal, HoldsTheDimensionsAsIncrements) {
  const std::string val = pattern_val(find_template("skirt"), whole_skirt());
  EXPECT_NE(val.find("<unit>cm</unit>"), std::string::npos);
  EXPECT_NE(val.find("name=\"#waist\" formula=\"72.0000\""), std::string::npos);
  EXPECT_EQ(val, pattern_val(find_template("skirt"), whole_skirt()));
}

}  // namespace
}  // namespace regarment
