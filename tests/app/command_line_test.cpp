#include "app/command_line.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

Command parse(std::vector<const char*> words) {
  words.insert(words.begin(), "regarment");
  return parse_command_line(static_cast<int>(words.size()), words.data());
}

TEST(CommandLine, ReadsAFit) {
  const auto fit = std::get<FitArguments>(
      parse({"fit",     "a.ply",   "--garment", "tshirt", "--garment", "skirt", "--out",
             "o",       "--force", "--seed",    "7",      "--threads", "2",     "--no-timing",
             "--units", "mm",      "--up",      "-z",     "--front",   "+x",    "--quiet"}));
  EXPECT_EQ(fit.scan, "a.ply");
  EXPECT_EQ(fit.garments, (std::vector<std::string>{"tshirt", "skirt"}));
  EXPECT_EQ(fit.out, "o");
  EXPECT_TRUE(fit.force);
  EXPECT_FALSE(fit.timing);
  EXPECT_EQ(fit.seed, 7u);
  EXPECT_EQ(fit.threads, 2);
  EXPECT_EQ(fit.units, "mm");
  EXPECT_EQ(fit.up, "-z");
  EXPECT_EQ(fit.front, "+x");
  EXPECT_TRUE(fit.speech.quiet);
  EXPECT_FALSE(fit.speech.json);
}

TEST(CommandLine, LeavesTheRestAtItsDefault) {
  const auto fit = std::get<FitArguments>(parse({"fit", "a", "--garment", "g", "--out", "o"}));
  EXPECT_FALSE(fit.force);
  EXPECT_TRUE(fit.timing);
  EXPECT_EQ(fit.method, "direct");
  EXPECT_EQ(fit.units, "auto");
  EXPECT_FALSE(fit.placement || fit.ground_truth || fit.ground_truth_labels);
}

TEST(CommandLine, ReadsTheOtherCommands) {
  EXPECT_EQ(std::get<ReportArguments>(parse({"report", "d"})).folder, "d");
  EXPECT_EQ(std::get<RenderArguments>(parse({"render", "a", "b", "--out", "o"})).meshes.size(), 2u);
  EXPECT_EQ(std::get<TemplatesArguments>(parse({"templates", "skirt"})).name, "skirt");
  EXPECT_FALSE(std::get<TemplatesArguments>(parse({"templates"})).name);
}

TEST(CommandLine, AnswersHelpBeforeItMissesAnything) {
  EXPECT_FALSE(std::get<TextAnswer>(parse({"fit", "--help"})).text.empty());
  EXPECT_FALSE(std::get<TextAnswer>(parse({"--version"})).text.empty());
}

TEST(CommandLine, AGarmentTakesOneValueATime) {
  EXPECT_THROW(parse({"fit", "a", "--out", "o", "--garment", "g", "h"}), UsageError);
}

}  // namespace
}  // namespace regarment
