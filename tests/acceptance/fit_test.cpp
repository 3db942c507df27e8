#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
    }
  }
  return files;
}

ProgramRun fit(const fs::path& scan, const fs::path& out, Arguments more = {}) {
  Arguments all = {"fit", scan, "--garment", "skirt", "--out", out};
  all.insert(all.end(), more.begin(), more.end());
  return run_program(all, kFitSeconds);
}

// Where it does not matter how dimensions are found, the fastest method finds them.
ProgramRun fit_quickly(const fs::path& scan, const fs::path& out, Arguments more = {}) {
  more.insert(more.end(), {"--method", "direct"});
  return fit(scan, out, std::move(more));
}

TEST(Fit, WritesTheResultAndSaysWhereTheReportIs) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "out";
  const ProgramRun run = fit(example("skirt-1.mesh.ply"), out,
                             {"--ground-truth", example("ground_truth.csv"),
                              "--ground-truth-labels", example("skirt-1.mesh.labels.u8")});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, (out / "report.html").string() + "\n");
  for (const char* name :
       {"report.html", "result.json", "labels.u8", "borders.json", "segmented.ply", "filled.ply",
        "garment-1.ply", "pattern-1.json", "pattern-1.svg", "measurements.csv"}) {
    EXPECT_TRUE(fs::is_regular_file(out / name)) << name;
  }
  EXPECT_EQ(fs::file_size(out / "labels.u8"), fs::file_size(example("skirt-1.mesh.labels.u8")));
  const Json result = Json::parse(bytes_of(out / "result.json"));
  EXPECT_EQ(result.at("garments").at(0).at("measurements").at(0).at("truth_cm"), 54.0);
  EXPECT_GT(result.at("segmentation").at("truth").at("mean_iou"), 0.93);
}

TEST(Fit, TwoRunsWithoutTimingHaveTheSameBytesWhateverTheThreads) {
  const TemporaryFolder home;
  const fs::path scan = example("skirt-1.mesh.ply");
  ASSERT_EQ(fit(scan, home.path() / "a", {"--no-timing", "--threads", "1"}).status, 0);
  ASSERT_EQ(fit(scan, home.path() / "b/c", {"--no-timing", "--threads", "2"}).status, 0);
  const auto a = files_below(home.path() / "a"), b = files_below(home.path() / "b/c");
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, bytes] : a) {
    EXPECT_TRUE(b.contains(name) && b.at(name) == bytes) << name;
    EXPECT_EQ(bytes.find(home.path().string()), std::string::npos) << name;
  }
}

TEST(Fit, ACacheChangesNoByteAndIsUsed) {
  const TemporaryFolder home;
  const fs::path scan = example("skirt-1.mesh.ply"), cache = home.path() / "cache";
  const auto run = [&](const char* out, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"--no-timing", "--ground-truth-labels",
                                    example("skirt-1.mesh.labels.u8")};
    all.insert(all.end(), more.begin(), more.end());
    EXPECT_EQ(fit_quickly(scan, home.path() / out, all).status, 0);
    return files_below(home.path() / out);
  };
  const auto without = run("a", {});
  EXPECT_EQ(run("b", {"--cache", cache}), without);
  const std::vector<std::string> kept = names_in(cache);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(run("c", {"--cache", cache}), without);
  EXPECT_EQ(names_in(cache), kept);
  // What is broken in the folder is prepared again.
  const std::string whole = bytes_of(cache / kept[0]);
  fs::resize_file(cache / kept[0], fs::file_size(cache / kept[0]) / 2);
  EXPECT_EQ(run("d", {"--cache", cache}), without);
  EXPECT_EQ(bytes_of(cache / kept[0]), whole);
  run("e", {"--cache", cache, "--up", "+z"});
  EXPECT_EQ(names_in(cache).size(), 2U);
}

// Few drapes: what is written, not how exact it is.
TEST(Fit, AnnealingWritesItsEvaluations) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "out";
  const ProgramRun run = fit(example("skirt-1.mesh.ply"), out,
                             {"--method", "annealing", "--runs", "1", "--evaluations", "20",
                              "--no-rough-search", "--no-timing"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json result = Json::parse(bytes_of(out / "result.json"));
  EXPECT_EQ(result.at("program").at("method"), "annealing");
  const Json& runs = result.at("garments").at(0).at("runs");
  ASSERT_EQ(runs.size(), 1U);
  const std::size_t evaluations = runs.at(0).at("evaluations");
  EXPECT_GE(evaluations, 6U);  // a simplex of four dimensions and one move
  EXPECT_LE(evaluations, 20U);
  // One row each, below the names of the columns.
  EXPECT_EQ(lines_of(bytes_of(out / "evaluations-1.csv")).size(), evaluations + 1);
  // The report of the stored result is the same one.
  const std::string page = bytes_of(out / "report.html");
  ASSERT_EQ(run_program({"report", out, "--quiet"}, kFitSeconds).status, 0);
  EXPECT_EQ(bytes_of(out / "report.html"), page);
}

TEST(Fit, SpeaksOnlyJsonWhenAsked) {
  const TemporaryFolder home;
  const ProgramRun run =
      fit_quickly(example("skirt-1.mesh.ply"), home.path() / "out", {"--json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out, bytes_of(home.path() / "out/result.json"));
  EXPECT_TRUE(Json::accept(run.out));
}

TEST(Fit, QuietSaysNothing) {
  const TemporaryFolder home;
  const ProgramRun run = fit_quickly(example("skirt-1.mesh.ply"), home.path() / "out", {"--quiet"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out + run.err, "");
}

TEST(Fit, ReplacesAFullFolderOnlyByForce) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "out";
  fs::create_directory(out);
  std::ofstream(out / "old.txt") << "old";
  expect_failure(fit(example("skirt-1.mesh.ply"), out), 2, "--force");
  EXPECT_EQ(fit_quickly(example("skirt-1.mesh.ply"), out, {"--force"}).status, 0);
  EXPECT_FALSE(fs::exists(out / "old.txt"));
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{"out"});
}

// Names of files are text from outside like any other.
TEST(Fit, NamesCannotRunInThePageNorInASpreadsheet) {
  const TemporaryFolder home;
  for (const std::string name : {"<img src=x onerror=alert(1)>.ply", "=cmd().ply", "{{file}}.ply",
                                 "a\nb\x1b[2J\xff.ply", "--out.ply"}) {
    fs::copy_file(example("skirt-1.mesh.ply"), home.path() / name);
    const fs::path out = home.path() / "out";
    const ProgramRun run = fit_quickly(home.path() / name, out, {"--force"});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string page = bytes_of(out / "report.html");
    EXPECT_EQ(page.find("<img src=x"), std::string::npos);
    EXPECT_EQ(page.find('\x1b'), std::string::npos);
    EXPECT_EQ(page.find('\xff'), std::string::npos);
    EXPECT_TRUE(Json::accept(bytes_of(out / "result.json")));
    for (const std::string& line : lines_of(bytes_of(out / "measurements.csv"))) {
      EXPECT_EQ(line.find(",="), std::string::npos);
      EXPECT_FALSE(line.starts_with("="));
    }
  }
}

// A body of the shared scans, when they are there.
TEST(Fit, ANakedBodyHasNoSkirt) {
  const char* given = std::getenv("REGARMENT_SHARED");
  const fs::path shared = given != nullptr ? given : fs::path(REGARMENT_SOURCE) / "../shared";
  const fs::path body = shared / "scans/artist/naked-female.obj";
  if (!fs::exists(body)) GTEST_SKIP() << body << " is not there";
  const TemporaryFolder home;
  expect_failure(fit(body, home.path() / "out", {"--quiet"}), 4);
  EXPECT_EQ(names_in(home.path()), std::vector<std::string>{});
}

}  // namespace
}  // namespace regarment
