#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Json json_of(const fs::path& out) { return Json::parse(bytes_of(out / "evaluation.json")); }

// A table beside the program's example scans: the rows of the example table that begin so.
fs::path table_of(const fs::path& home, const std::string& scan, const std::string& more = "") {
  std::ofstream table(home / "truth.csv");
  bool head = true;
  for (const std::string& line : lines_of(bytes_of(example("ground_truth.csv")))) {
    if (head || line.starts_with(scan + ",")) table << line << "\n";
    head = false;
  }
  table << more;
  return home / "truth.csv";
}

Arguments evaluate_as_told(const fs::path& table, const fs::path& out, const Arguments& more = {}) {
  Arguments all = {"evaluate", table, "--out", out, "--scans", example("").parent_path()};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// What is evaluated is found by the fastest method, unless `more` says otherwise.
Arguments evaluate(const fs::path& table, const fs::path& out, Arguments more = {}) {
  if (std::find(more.begin(), more.end(), "--method") == more.end())
    more.insert(more.end(), {"--method", "direct"});
  return evaluate_as_told(table, out, more);
}

TEST(Evaluate, MeasuresTheExamplesAndSumsUp) {
  const TemporaryFolder home;
  const fs::path one = home.path() / "one", two = home.path() / "two";
  const ProgramRun run =
      run_program(evaluate(example("ground_truth.csv"), one,
                           {"--no-timing", "--jobs", "1", "--gate", "mae_cm<=4"}),
                  3 * kFitSeconds);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, (one / "evaluation.html").string() + "\n");
  EXPECT_EQ(names_in(one), (std::vector<std::string>{"evaluation.csv", "evaluation.html",
                                                     "evaluation.json", "fits"}));
  const Json result = json_of(one);
  EXPECT_EQ(result.at("scans").size(), 3u);
  const Json& all = result.at("statistics").at(0).at("values");
  EXPECT_EQ(all.at("n"), 16);
  EXPECT_EQ(all.at("hidden"), 2);
  EXPECT_EQ(all.at("labelled"), 3);
  EXPECT_TRUE(fs::exists(one / "fits/skirt-1.mesh/report.html"));

  // The same bytes with two at once.
  ASSERT_EQ(run_program(evaluate(example("ground_truth.csv"), two,
                                 {"--no-timing", "--jobs", "2", "--gate", "mae_cm<=4", "--quiet"}),
                        3 * kFitSeconds)
                .status,
            0);
  for (const char* name : {"evaluation.csv", "evaluation.html", "evaluation.json"}) {
    EXPECT_EQ(bytes_of(one / name), bytes_of(two / name)) << name;
  }

  // What it wrote is a baseline, and its table estimates.
  const ProgramRun again = run_program(
      {"evaluate", example("ground_truth.csv"), "--out", home.path() / "three", "--estimates",
       one / "evaluation.csv", "--baseline", one / "evaluation.json", "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  const Json compared = Json::parse(again.out);
  // The table has three digits.
  EXPECT_NEAR(compared.at("statistics").at(0).at("values").at("mae_cm").get<double>(),
              all.at("mae_cm").get<double>(), 0.001);
  EXPECT_EQ(compared.at("baseline").at("file"), "evaluation.json");
}

TEST(Evaluate, KeepsFinishedFitsAndMakesOthersAgain) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "e", mark = out / "fits/skirt-1.mesh/mark";
  const fs::path table = table_of(home.path(), "skirt-1");
  ASSERT_EQ(run_program(evaluate(table, out), kFitSeconds).status, 0);
  std::ofstream(mark) << "a fit made again replaces the folder";
  ASSERT_EQ(run_program(evaluate(table, out), kFitSeconds).status, 0);
  EXPECT_TRUE(fs::exists(mark)) << "nothing changed";
  ASSERT_EQ(run_program(evaluate(table, out, {"--seed", "2"}), kFitSeconds).status, 0);
  EXPECT_FALSE(fs::exists(mark)) << "another option";
  std::ofstream(mark) << "x";
  ASSERT_EQ(run_program(evaluate(table, out, {"--seed", "2", "--force"}), kFitSeconds).status, 0);
  EXPECT_FALSE(fs::exists(mark)) << "asked for";
}

TEST(Evaluate, MakesAFitAgainWhenTheScanChanged) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "e", scan = home.path() / "skirt-1.mesh.ply";
  fs::copy_file(example("skirt-1.mesh.ply"), scan);
  const fs::path table = table_of(home.path(), "skirt-1");
  const Arguments all = {"evaluate", table, "--out", out, "--quiet", "--method", "direct"};
  ASSERT_EQ(run_program(all, kFitSeconds).status, 0);
  const Json before = Json::parse(bytes_of(out / "fits/skirt-1.mesh/result.json"));
  std::ofstream(scan, std::ios::app) << "\n";  // bytes behind the mesh are no part of it
  const ProgramRun run = run_program(all, kFitSeconds);
  const fs::path result = out / "fits/skirt-1.mesh/result.json";
  if (run.status == 0) {
    EXPECT_NE(Json::parse(bytes_of(result)).at("scan").at("sha256"),
              before.at("scan").at("sha256"));
  } else {
    EXPECT_FALSE(fs::exists(result)) << "a stale result";
  }
}

TEST(Evaluate, GoesOnPastFailuresAndSaysSo) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "flat.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const fs::path out = home.path() / "e";
  const fs::path table = table_of(home.path(), "skirt-1",
                                  "flat.off,1,skirt,hip,90,,true\nnone.ply,1,skirt,hip,90,,true\n");
  const ProgramRun run = run_program(evaluate(table, out, {"--quiet"}), kFitSeconds);
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_NE(run.err.find("2 of 3 scans"), std::string::npos) << run.err;
  const Json result = json_of(out);
  EXPECT_EQ(result.at("statistics").at(0).at("values").at("failures"), 2);
  EXPECT_EQ(result.at("statistics").at(0).at("values").at("n"), 4);
  EXPECT_EQ(result.at("scans").at(1).at("failure").at("status"), 3);
  // Who allows for failures has them.
  EXPECT_EQ(
      run_program(evaluate(table, out, {"--quiet", "--gate", "failures<=2"}), kFitSeconds).status,
      0);
}

TEST(Evaluate, AFitThatTakesTooLongIsAFailure) {
  const TemporaryFolder home;
  const fs::path table = table_of(home.path(), "skirt-1");
  const ProgramRun run = run_program(evaluate(table, home.path() / "e",
                                              {"--quiet", "--timeout", "1", "--method", "annealing",
                                               "--evaluations", "100000", "--gate", "failures<=1"}),
                                     kFitSeconds);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(json_of(home.path() / "e").at("scans").at(0).at("failure").at("kind"), "time-out");
}

TEST(Evaluate, EachFailedGateHasItsLine) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "other.csv") << "scan,measurement,value_cm\nskirt-1,hip,96\n";
  const ProgramRun run =
      run_program({"evaluate", table_of(home.path(), "skirt-1"), "--out", home.path() / "e",
                   "--estimates", home.path() / "other.csv", "--gate", "mae_cm<=1.9", "--gate",
                   "skirt.hip.bias_cm > 1.9", "--gate", "coverage>=0.8", "--quiet"});
  EXPECT_EQ(run.status, 5);
  const std::vector<std::string> lines = lines_of(run.err);
  ASSERT_EQ(lines.size(), 2u) << run.err;
  EXPECT_EQ(lines[0], "regarment: gate failed: mae_cm<=1.9: the value is 2.000");
  EXPECT_EQ(lines[1], "regarment: gate failed: coverage>=0.8: nothing could be measured");
}

TEST(Evaluate, SaysWhatIsWrongBeforeAnyFit) {
  const TemporaryFolder home;
  const fs::path table = table_of(home.path(), "skirt-1"), out = home.path() / "e";
  expect_failure(run_program(evaluate(table, out, {"--gate", "tshirt.mae_cm<1"})), 2, "no group");
  expect_failure(run_program(evaluate(table, out, {"--args", "--garment tshirt"})), 2, "garments");
  expect_failure(run_program(evaluate(table, out, {"--method", "magic"})), 2, "--method");
  expect_failure(run_program(evaluate(table, out, {"--baseline", table})), 3, "truth.csv");
  expect_failure(run_program(evaluate(table, out, {"--only", "shirt*"})), 2, "--only");
  expect_failure(run_program(evaluate(table, home.path())), 2, "choose another --out");
  const fs::path bad = table_of(home.path(), "skirt-1", "skirt-1,1,skirt,knee,50,,true\n");
  expect_failure(run_program(evaluate(bad, out)), 3, "line 6, column measurement");
  EXPECT_FALSE(fs::exists(out / "fits/skirt-1.mesh"));
}

// The line that tells of the one scan that is done.
std::string first_line(const Json& evaluation, std::size_t scans) {
  std::array<char, 100> line{};
  std::snprintf(line.data(), line.size(), "fit: scan 1 of %zu, mean error %.2f cm", scans,
                evaluation.at("scans").at(0).at("mean_error_cm").get<double>());
  return line.data();
}

TEST(Evaluate, StopsItsFitsWhenItIsStoppedAndGoesOnLater) {
  const TemporaryFolder home;
  const fs::path table = home.path() / "truth.csv", out = home.path() / "e";
  std::ofstream(table) << "scan,layer,template,measurement,value_cm,options\n"
                       << "skirt-1,1,skirt,hip,94,--method direct\n"
                       << "tshirt-5,1,tshirt,width,96,--method annealing --evaluations 100000\n";
  ASSERT_EQ(run_program(evaluate_as_told(table, out, {"--only", "skirt*"}), kFitSeconds).status, 0);
  const std::string done = first_line(json_of(out), 2);
  // The finished fit is found again and told; the other would take hours.
  RunningProgram program(evaluate_as_told(table, out), kFitSeconds);
  ASSERT_TRUE(program.wait_for_line(done));
  program.send(SIGTERM);
  const ProgramRun run = program.finish();
  EXPECT_EQ(run.status, 143) << run.err;
  EXPECT_TRUE(lines_of(run.err).back().starts_with("regarment: stopped by")) << run.err;
  EXPECT_EQ(names_in(out / "fits"), std::vector<std::string>{"skirt-1.mesh"});
  EXPECT_EQ(json_of(out).at("scans").size(), 1u) << "the evaluation of before stays";
}

}  // namespace
}  // namespace regarment
