#include "evaluation/fit_job.h"

#include <gtest/gtest.h>

#include <fstream>

#include "evaluations.h"
#include "support/folders.h"

namespace regarment {
namespace {

FitJobOptions usual() {
  return {"/bin/regarment", "t.csv", "out/fits", {"--method", "direct"}, 2, true};
}

EvaluationCase one() {
  EvaluationCase out = skirt_scan("a", {0}).about;
  out.truth_rows = "1|skirt|length|54|\n";
  return out;
}

TEST(FitJob, IsAWholeCommand) {
  EvaluationCase scan = one();
  scan.options = {"--up", "+z"};
  const FitJob job = make_fit_job(scan, usual(), "ff");
  EXPECT_EQ(job.command, (std::vector<std::string>{
                             "/bin/regarment", "fit", "a.ply", "--garment", "skirt", "--quiet",
                             "--no-state", "--threads", "2", "--ground-truth", "t.csv", "--method",
                             "direct", "--up", "+z", "--out", "out/fits/a", "--force"}));
}

TEST(FitJob, APathIsNeverTakenForAnOption) {
  EvaluationCase scan = one();
  scan.scan = "--help";
  EXPECT_EQ(make_fit_job(scan, usual(), "ff").command[2], "./--help");
}

TEST(FitJob, ItsKeyTellsWhatChangesTheResult) {
  const std::string key = make_fit_job(one(), usual(), "ff").key;
  EXPECT_EQ(make_fit_job(one(), usual(), "ff").key, key);
  EXPECT_NE(make_fit_job(one(), usual(), "fe").key, key) << "another program";
  FitJobOptions how = usual();
  how.options.push_back("--collisions");
  EXPECT_NE(make_fit_job(one(), how, "ff").key, key);
  how = usual();
  how.timing = false;
  EXPECT_NE(make_fit_job(one(), how, "ff").key, key);
  EvaluationCase scan = one();
  scan.truth_rows = "1|skirt|length|55|\n";
  EXPECT_NE(make_fit_job(scan, usual(), "ff").key, key);
  scan = one();
  scan.garments = {"tshirt"};
  EXPECT_NE(make_fit_job(scan, usual(), "ff").key, key);
}

TEST(FitJob, ItsKeyDoesNotDependOnThreads) {
  FitJobOptions how = usual();
  how.threads = 7;
  EXPECT_EQ(make_fit_job(one(), how, "ff").key, make_fit_job(one(), usual(), "ff").key);
}

TEST(FitJob, ItsKeyKnowsTheLabelsBytes) {
  const TemporaryFolder home;
  EvaluationCase scan = one();
  scan.labels = home.path() / "a.u8";
  std::ofstream(*scan.labels) << "000";
  const std::string key = make_fit_job(scan, usual(), "ff").key;
  std::ofstream(*scan.labels) << "001";
  EXPECT_NE(make_fit_job(scan, usual(), "ff").key, key);
}

TEST(FitJob, ItsKeyKnowsTheBytesOfFilesAmongTheOptions) {
  const TemporaryFolder home;
  const std::string file = home.path() / "placement.json";
  FitJobOptions how = usual();
  how.options = {"--placement", file};
  std::ofstream(file) << "{}";
  const std::string key = make_fit_job(one(), how, "ff").key;
  EXPECT_EQ(make_fit_job(one(), how, "ff").key, key);
  std::ofstream(file) << "{ }";
  EXPECT_NE(make_fit_job(one(), how, "ff").key, key);
}

TEST(FitJob, IsNotFinishedWithoutAResult) {
  const TemporaryFolder home;
  FitJobOptions how = usual();
  how.fits = home.path();
  const FitJob job = make_fit_job(one(), how, "ff");
  EXPECT_FALSE(is_finished(job, one()));
  std::filesystem::create_directories(job.folder);
  mark_finished(job);
  EXPECT_FALSE(is_finished(job, one()));
  std::ofstream(job.folder / "result.json") << "{}";
  EXPECT_FALSE(is_finished(job, one()));
}

}  // namespace
}  // namespace regarment
