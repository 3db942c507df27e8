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

TEST(CommandLine, ReadsARefit) {
  const auto refit = std::get<RefitArguments>(
      parse({"refit", "d", "--out", "o", "--fix", "hip=95", "--forget", "--method", "annealing"}));
  EXPECT_EQ(refit.folder, "d");
  EXPECT_EQ(refit.out, "o");
  EXPECT_EQ(refit.known.fix, std::vector<std::string>{"hip=95"});
  EXPECT_TRUE(refit.forget && refit.timing && refit.state);
  EXPECT_EQ(refit.method, "annealing");
  EXPECT_THROW(parse({"refit", "d"}), UsageError);  // would replace it
  EXPECT_FALSE(std::get<RefitArguments>(parse({"refit", "d", "--force"})).out);
  EXPECT_THROW(parse({"refit", "d", "--force", "--method", "guess"}), UsageError);
  EXPECT_THROW(parse({"refit", "d", "--force", "--hint", "waist_edge"}), UsageError);
}

TEST(CommandLine, LeavesTheRestAtItsDefault) {
  const auto fit = std::get<FitArguments>(parse({"fit", "a", "--garment", "g", "--out", "o"}));
  EXPECT_FALSE(fit.force);
  EXPECT_TRUE(fit.timing);
  EXPECT_EQ(fit.method, "joint");
  EXPECT_EQ(fit.units, "auto");
  EXPECT_FALSE(fit.placement || fit.ground_truth || fit.ground_truth_labels);
}

TEST(CommandLine, ReadsWhatAnnealingCanBeTold) {
  const auto fit = std::get<FitArguments>(parse({"fit",
                                                 "a",
                                                 "--garment",
                                                 "g",
                                                 "--out",
                                                 "o",
                                                 "--method",
                                                 "annealing",
                                                 "--runs",
                                                 "2",
                                                 "--evaluations",
                                                 "40",
                                                 "--segment-distance",
                                                 "7.5",
                                                 "--attraction",
                                                 "closest",
                                                 "--normal-angle",
                                                 "45",
                                                 "--layer-attenuation",
                                                 "0.3",
                                                 "--drape-from",
                                                 "last",
                                                 "--collisions",
                                                 "--no-cap-detection",
                                                 "--no-border-rejection",
                                                 "--free-edges",
                                                 "--no-rough-search",
                                                 "--no-hesitation",
                                                 "--no-square-root"}));
  EXPECT_EQ(fit.method, "annealing");
  const AnnealingArguments& a = fit.annealing;
  EXPECT_EQ(a.runs, 2);
  EXPECT_EQ(a.evaluations, 40);
  EXPECT_EQ(a.segment_distance_mm, 7.5);
  EXPECT_EQ(a.attraction, "closest");
  EXPECT_EQ(a.normal_angle_deg, 45);
  EXPECT_EQ(a.layer_attenuation, 0.3);
  EXPECT_EQ(a.drape_from, "last");
  EXPECT_TRUE(a.collisions);
  EXPECT_FALSE(a.cap_detection || a.border_rejection || a.held_edges);
  EXPECT_FALSE(a.rough_search || a.hesitation || a.square_root);
  EXPECT_FALSE(a.as_printed);
}

TEST(CommandLine, EachSwitchOfAnnealingMovesOneThing) {
  const std::vector<std::pair<const char*, bool AnnealingArguments::*>> switches = {
      {"--collisions", &AnnealingArguments::collisions},
      {"--no-cap-detection", &AnnealingArguments::cap_detection},
      {"--no-border-rejection", &AnnealingArguments::border_rejection},
      {"--free-edges", &AnnealingArguments::held_edges},
      {"--no-rough-search", &AnnealingArguments::rough_search},
      {"--no-hesitation", &AnnealingArguments::hesitation},
      {"--no-square-root", &AnnealingArguments::square_root},
      {"--as-printed", &AnnealingArguments::as_printed}};
  const AnnealingArguments usual;
  for (const auto& [name, member] : switches) {
    const auto fit = std::get<FitArguments>(
        parse({"fit", "a", "--garment", "g", "--out", "o", "--method", "annealing", name}));
    for (const auto& [other, its_member] : switches)
      EXPECT_EQ(fit.annealing.*its_member != usual.*its_member, member == its_member)
          << name << " and " << other;
  }
}

TEST(CommandLine, RefusesNumbersThatAnnealingCannotUse) {
  const std::vector<std::pair<const char*, const char*>> bad = {{"--runs", "0"},
                                                                {"--runs", "101"},
                                                                {"--evaluations", "19"},
                                                                {"--normal-angle", "0"},
                                                                {"--normal-angle", "181"},
                                                                {"--segment-distance", "-1"},
                                                                {"--drape-from", "here"},
                                                                {"--attraction", "sideways"},
                                                                {"--layer-attenuation", "1.1"},
                                                                {"--layer-attenuation", "nan"}};
  for (const auto& [option, value] : bad)
    EXPECT_THROW(parse({"fit", "a", "--garment", "g", "--out", "o", option, value}), UsageError)
        << option << " " << value;
}

TEST(CommandLine, ReadsAReview) {
  const auto a = std::get<ReviewArguments>(parse({"review", "a", "b", "--out", "r.html"}));
  EXPECT_EQ(a.folders, (std::vector<std::filesystem::path>{"a", "b"}));
  EXPECT_EQ(a.out, "r.html");
  EXPECT_FALSE(a.force);
  EXPECT_THROW(parse({"review", "--out", "r.html"}), UsageError);
  EXPECT_THROW(parse({"review", "a"}), UsageError);
  EXPECT_THROW(parse({"review", "a", "--out", "--force"}), UsageError);
}

TEST(CommandLine, ReadsAnEvaluation) {
  const auto a = std::get<EvaluateArguments>(
      parse({"evaluate",   "t.csv",  "--out",   "o",          "--scans",   "s",
             "--only",     "skirt*", "--gate",  "mae_cm<=1",  "--gate",    "miou>0.9",
             "--baseline", "b.json", "--jobs",  "3",          "--threads", "2",
             "--timeout",  "60",     "--force", "--no-timing"}));
  EXPECT_EQ(a.table, "t.csv");
  EXPECT_EQ(a.out, "o");
  EXPECT_EQ(a.scans, "s");
  EXPECT_EQ(a.only, "skirt*");
  EXPECT_EQ(a.gates, (std::vector<std::string>{"mae_cm<=1", "miou>0.9"}));
  EXPECT_EQ(a.baseline, "b.json");
  EXPECT_EQ(a.jobs, 3);
  EXPECT_EQ(a.threads, 2);
  EXPECT_EQ(a.timeout, 60);
  EXPECT_TRUE(a.force);
  EXPECT_FALSE(a.timing);
  EXPECT_TRUE(a.fit_options.empty());
}

TEST(CommandLine, AnEvaluationHandsOptionsOnToItsFits) {
  const auto a = std::get<EvaluateArguments>(
      parse({"evaluate", "t.csv", "--out", "o", "--args", "--collisions  --up +z", "--seed", "7",
             "--method", "annealing", "--runs", "2", "--evaluations", "40"}));
  const std::vector<std::string> words = {
      "--method",      "annealing", "--seed",       "7",    "--runs", "2",
      "--evaluations", "40",        "--collisions", "--up", "+z"};
  EXPECT_EQ(a.fit_options, words);
}

TEST(CommandLine, EstimatesAreNotFitted) {
  EXPECT_NO_THROW(parse({"evaluate", "t", "--out", "o", "--estimates", "e", "--gate", "n>1"}));
  for (const char* option : {"--scans", "--only", "--seed", "--args"})
    EXPECT_THROW(parse({"evaluate", "t", "--out", "o", "--estimates", "e", option, "1"}),
                 UsageError)
        << option;
  EXPECT_THROW(parse({"evaluate", "t", "--out", "o", "--estimates", "e", "--force"}), UsageError);
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

TEST(CommandLine, ReadsWhatPeopleToMake) {
  const auto made = std::get<SynthesizeArguments>(
      parse({"synthesize", "--out", "o", "--cases", "100", "--first", "7", "--seed", "3", "--kind",
             "open", "--garment", "tshirt", "--garment", "skirt", "--force"}));
  EXPECT_EQ(made.cases, 100);
  EXPECT_EQ(made.first, 7);
  EXPECT_EQ(made.seed, 3u);
  EXPECT_EQ(made.kind, "open");
  EXPECT_EQ(made.garments, (std::vector<std::string>{"tshirt", "skirt"}));
  EXPECT_TRUE(made.force);
  EXPECT_THROW(parse({"synthesize"}), UsageError);
  EXPECT_THROW(parse({"synthesize", "--out", "o", "--cases", "0"}), UsageError);
  EXPECT_THROW(parse({"synthesize", "--out", "o", "--kind", "film"}), UsageError);
}

}  // namespace
}  // namespace regarment
