#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Json result_in(const fs::path& folder) { return Json::parse(bytes_of(folder / "result.json")); }

/// A skirt fitted once, with truth and true labels; its scan is gone.
class Refit : public testing::Test {
 protected:
  explicit Refit(std::string method = "direct") : method_(std::move(method)) {}
  void SetUp() override {
    const fs::path scan = home_.path() / "scan.ply";
    fs::copy_file(example("skirt-1.mesh.ply"), scan);
    std::ofstream(home_.path() / "truth.csv") << "scan,measurement,value_cm,tol_plus_cm\n"
                                                 "scan.ply,length,54,0.5\n";
    const ProgramRun run = run_program(
        {"fit", scan, "--garment", "skirt", "--out", first_, "--no-timing", "--ground-truth",
         home_.path() / "truth.csv", "--ground-truth-labels", example("skirt-1.mesh.labels.u8"),
         "--hint", "waist_edge=101", "--method", method_},
        kFitSeconds);
    ASSERT_EQ(run.status, 0) << run.err;
    fs::remove(scan);
    fs::remove(home_.path() / "truth.csv");
  }
  ProgramRun refit(Arguments more) const {
    Arguments all = {"refit", first_, "--no-timing"};
    all.insert(all.end(), more.begin(), more.end());
    return run_program(all, kFitSeconds);
  }

  const std::string method_;
  const TemporaryFolder home_;
  const fs::path first_ = home_.path() / "first", second_ = home_.path() / "second";
};

class RefitOfTheDefaultMethod : public Refit {
 protected:
  RefitOfTheDefaultMethod() : Refit("joint") {}
};

TEST_F(RefitOfTheDefaultMethod, WithoutChangesGivesTheSameResult) {
  const ProgramRun run = refit({"--out", second_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, (second_ / "report.html").string() + "\n");
  Json first = result_in(first_), second = result_in(second_);
  EXPECT_FALSE(first.at("program").contains("refit"));
  EXPECT_EQ(second.at("program").at("refit"), true);
  second.at("program").erase("refit");
  EXPECT_EQ(first, second);
  for (const char* name : {"labels.u8", "segmented.ply", "filled.ply", "garment-1.ply", "state.bin",
                           "measurements.csv", "pictures/scan-front.jpg"})
    EXPECT_EQ(bytes_of(first_ / name), bytes_of(second_ / name)) << name;
}

TEST_F(Refit, TakesOverOptionsAndAddsHelp) {
  ASSERT_EQ(refit({"--force", "--fix", "length=50", "--fabric", "woven", "--no-state"}).status, 0);
  const Json result = result_in(first_);
  EXPECT_EQ(result.at("fabric"), "woven");
  EXPECT_EQ(result.at("program").at("options").at("hint"), "waist_edge=101");
  EXPECT_EQ(result.at("program").at("options").at("fix"), "length=50");
  const Json& length = result.at("garments").at(0).at("measurements").at(0);
  EXPECT_EQ(length.at("fixed"), true);
  EXPECT_EQ(length.at("value_cm"), 50.0);
  EXPECT_EQ(length.at("error_cm"), -4.0);
  EXPECT_TRUE(result.at("segmentation").contains("truth"));
  EXPECT_FALSE(fs::exists(first_ / "state.bin"));
  expect_failure(refit({"--force"}), 3, "--no-state");
}

TEST_F(Refit, NewHelpReplacesOldAndForgetsIt) {
  ASSERT_EQ(refit({"--out", second_, "--hint", "skirt.waist_edge=100.5"}).status, 0);
  EXPECT_EQ(result_in(second_).at("program").at("options").at("hint"), "skirt.waist_edge=100.5");
  ASSERT_EQ(refit({"--out", second_, "--forget", "--force"}).status, 0);
  EXPECT_FALSE(result_in(second_).at("program").at("options").contains("hint"));
}

TEST_F(Refit, RefusesWhatItCannotUse) {
  expect_failure(refit({}), 2, "--force");
  expect_failure(refit({"--out", second_, "--fix", "sleeve=3"}), 2, "length, width, waist, hip");
  expect_failure(run_program({"refit", home_.path() / "none", "--force"}, kFitSeconds), 2,
                 "is no folder");
  std::string state = bytes_of(first_ / "state.bin");
  state[state.size() / 2] ^= 1;
  std::ofstream(first_ / "state.bin", std::ios::binary) << state;
  expect_failure(refit({"--out", second_}), 3, "state.bin");
  EXPECT_FALSE(fs::exists(second_));
}

}  // namespace
}  // namespace regarment
