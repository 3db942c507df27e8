#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "failures.h"
#include "support/folders.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Two of the example scans, fitted by the fastest method.
fs::path table_in(const fs::path& home, const std::string& more = "") {
  std::ofstream(home / "table.csv") << "scan,layer,template,measurement,value_cm,options\n"
                                    << "skirt-1,1,skirt,hip,94,--method direct\n"
                                    << more;
  return home / "table.csv";
}

constexpr const char* kSecond = "tshirt-5,1,tshirt,width,96,--method direct\n";
constexpr const char* kEndless =
    "tshirt-5,1,tshirt,width,96,--method annealing --evaluations 100000\n";

Arguments batch(const fs::path& table, const fs::path& out, const Arguments& more = {}) {
  Arguments all = {"batch", table, "-o", out, "--scans", example("").parent_path()};
  all.insert(all.end(), {"--shard-size", "1", "--quiet"});
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// What every engine must write alike.
std::map<fs::path, std::string> files_of(const fs::path& folder) {
  std::map<fs::path, std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path name = entry.path().lexically_relative(folder);
    const bool of_slurm = name.extension() == ".sbatch" || name == "submit.sh";
    if (entry.is_regular_file() && !of_slurm) out[name] = bytes_of(entry.path());
  }
  return out;
}

void expect_same_files(const fs::path& one, const fs::path& other) {
  const auto ours = files_of(one), theirs = files_of(other);
  EXPECT_EQ(ours.size(), theirs.size());
  for (const auto& [name, bytes] : ours) {
    EXPECT_TRUE(theirs.contains(name) && theirs.at(name) == bytes) << name;
  }
}

// Kills the program once it has begun to fit this scan.
void kill_at(RunningProgram& program, const fs::path& out, const std::string& scan, int signal) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kFitSeconds);
  while (!fs::exists(out / "attempts" / scan) && std::chrono::steady_clock::now() < end) {
  }
  ASSERT_TRUE(fs::exists(out / "attempts" / scan));
  program.send(signal);
}

TEST(Batch, WritesTheSameBytesWhoeverDoesTheWork) {
  const TemporaryFolder home;
  const fs::path table = table_in(home.path(), kSecond), two = home.path() / "two";
  const ProgramRun run = run_program(batch(table, two, {"--workers", "2"}), 2 * kFitSeconds);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(Json::parse(bytes_of(two / "evaluation.json")).at("scans").size(), 2u);
  EXPECT_TRUE(fs::exists(two / "fits/tshirt-5.mesh/report.html"));

  // One worker, killed with one scan done and another begun.
  const fs::path one = home.path() / "one";
  ASSERT_EQ(run_program(batch(table, one, {"--only", "skirt*"}), kFitSeconds).status, 0);
  const auto first = fs::last_write_time(one / "fits/skirt-1.mesh/result.json");
  {
    RunningProgram program(batch(table, one, {"--workers", "1"}), kFitSeconds);
    kill_at(program, one, "tshirt-5.mesh", SIGKILL);
    EXPECT_EQ(program.finish().status, 1000 + SIGKILL);
  }
  ASSERT_EQ(run_program(batch(table, one, {"--workers", "1"}), kFitSeconds).status, 0);
  EXPECT_EQ(fs::last_write_time(one / "fits/skirt-1.mesh/result.json"), first) << "kept";
  expect_same_files(two, one);

  // The tasks that Slurm would run, the last one's scan left to the merge.
  const fs::path tasks = home.path() / "its tasks";
  ASSERT_EQ(run_program(batch(table, tasks, {"--engine", "slurm", "--dry-run"})).status, 0);
  EXPECT_TRUE(fs::exists(tasks / "array.sbatch") && fs::exists(tasks / "submit.sh"));
  ASSERT_EQ(run_program({"batch-task", tasks, "--shard", "0", "--quiet"}, kFitSeconds).status, 0);
  expect_failure(run_program({"batch-task", tasks, "--shard", "2", "--quiet"}), 2, "0 to 1");
  ASSERT_EQ(run_program({"batch-task", tasks, "--merge", "--quiet"}, kFitSeconds).status, 0);
  expect_same_files(two, tasks);
}

TEST(Batch, NeedsNoTruth) {
  const TemporaryFolder home;
  const fs::path table = home.path() / "table.csv", out = home.path() / "b";
  std::ofstream(table) << "scan,template\nskirt-1,skirt\n";
  const ProgramRun run = run_program(batch(table, out, {"--method", "direct"}), kFitSeconds);
  ASSERT_EQ(run.status, 0) << run.err;
  const Json all = Json::parse(bytes_of(out / "evaluation.json"));
  EXPECT_EQ(all.at("statistics").at(0).at("values").at("scans"), 1);
  EXPECT_EQ(all.at("statistics").at(0).at("values").at("n"), 0);
  EXPECT_NE(bytes_of(out / "evaluation.html").find("1 scan measured"), std::string::npos);
  EXPECT_EQ(bytes_of(out / "evaluation.html").find("MAE</dt>"), std::string::npos);
  // The sizes are those of the fit, to the digits of its table.
  const auto ours = lines_of(bytes_of(out / "measurements.csv"));
  const auto fit = lines_of(bytes_of(out / "fits/skirt-1.mesh/measurements.csv"));
  ASSERT_EQ(ours.size(), 5u) << "a skirt has four dimensions";
  for (std::size_t i = 1; i < ours.size(); ++i) {
    EXPECT_TRUE(("skirt-1.mesh," + fit.at(i)).starts_with(ours[i] + ",")) << ours[i];
  }
}

TEST(Batch, BeingStoppedCostsNothing) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "b";
  RunningProgram program(batch(table_in(home.path(), kEndless), out, {"--workers", "2"}),
                         kFitSeconds);
  kill_at(program, out, "tshirt-5.mesh", SIGTERM);
  const ProgramRun run = program.finish();
  EXPECT_EQ(run.status, 143) << run.err;
  EXPECT_EQ(names_in(out / "attempts"), std::vector<std::string>{});
  const ProgramRun status = run_program({"batch", "--status", out, "--json"});
  EXPECT_EQ(status.status, 0) << status.err;
  EXPECT_GE(Json::parse(status.out).at("to_be_done"), 1);
}

TEST(Batch, GoesOnPastFailuresAndSaysSo) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "flat.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const fs::path out = home.path() / "b";
  const fs::path table =
      table_in(home.path(), "flat.off,1,skirt,hip,90,\nnone.ply,1,skirt,hip,90,\n");
  const ProgramRun run = run_program(batch(table, out), kFitSeconds);
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_NE(run.err.find("2 of 3 scans"), std::string::npos) << run.err;
  const ProgramRun status = run_program({"batch", "--status", out});
  const auto lines = lines_of(status.out);
  ASSERT_EQ(lines.size(), 3u) << status.out;
  EXPECT_EQ(lines[0], "3 of 3 scans: 1 succeeded, 2 failed, 0 parked, 0 to be done");
  EXPECT_TRUE(lines[1].starts_with("failed  flat: ")) << lines[1];
  // Who allows for failures has them; none is fitted again.
  const auto before = fs::last_write_time(out / "status/flat.json");
  EXPECT_EQ(run_program(batch(table, out, {"--gate", "failures<=2"}), kFitSeconds).status, 0);
  EXPECT_EQ(fs::last_write_time(out / "status/flat.json"), before);
  EXPECT_EQ(run_program(batch(table, out, {"--gate", "failures<=1"}), kFitSeconds).status, 5);
}

TEST(Batch, DoesNotMixTwoPlans) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "b", table = table_in(home.path());
  const Arguments dry = {"--engine", "slurm", "--dry-run"};
  ASSERT_EQ(run_program(batch(table, out, dry)).status, 0);
  table_in(home.path(), kSecond);
  expect_failure(run_program({"batch-task", out, "--shard", "0", "--quiet"}), 2, "run 'regarment");
  EXPECT_FALSE(fs::exists(out / "fits/skirt-1.mesh"));
}

TEST(Batch, SaysWhetherItIsSummedUp) {
  const TemporaryFolder home;
  const fs::path out = home.path() / "b";
  const auto status = [&] { return run_program({"batch", "--status", out}).out; };
  const auto merged = [&] {
    return Json::parse(run_program({"batch", "--status", out, "--json"}).out)
        .at("merged")
        .get<bool>();
  };
  const fs::path table = home.path() / "table.csv";
  std::ofstream(table) << "scan,template\nnone.ply,skirt\n";
  ASSERT_EQ(run_program(batch(table, out)).status, 4);
  EXPECT_TRUE(merged());
  EXPECT_EQ(status().find("not summed up"), std::string::npos);
  // Planned again as it is, it stays; Slurm may forget a merge it took.
  const Arguments dry = {"--engine", "slurm", "--dry-run"};
  ASSERT_EQ(run_program(batch(table, out, dry)).status, 0);
  EXPECT_TRUE(merged());
  fs::remove(out / "evaluation.json");
  EXPECT_FALSE(merged());
  EXPECT_NE(status().find("not summed up yet"), std::string::npos);
  // The sum of one plan is none of another's.
  ASSERT_EQ(run_program(batch(table, out)).status, 4);
  ASSERT_EQ(
      run_program(batch(table, out, {"--engine", "slurm", "--dry-run", "--seed", "2"})).status, 0);
  EXPECT_FALSE(merged());
  EXPECT_EQ(names_in(out),
            (std::vector<std::string>{".lock", "array.sbatch", "attempts", "fits", "log",
                                      "manifest.json", "merge.sbatch", "status", "submit.sh"}));
}

TEST(Batch, SaysWhatIsWrongBeforeAnyFit) {
  const TemporaryFolder home;
  const fs::path table = table_in(home.path()), out = home.path() / "b";
  expect_failure(run_program({"batch", table}), 2, "--out");
  expect_failure(run_program({"batch", "--status", out}), 3, "manifest.json");
  expect_failure(run_program({"batch", table, "--status", out}), 2, "--status");
  expect_failure(run_program(batch(table, home.path())), 2, "choose another --out");
  expect_failure(run_program(batch(table, out, {"--engine", "cloud"})), 2, "--engine");
  expect_failure(run_program(batch(table, out, {"--dry-run"})), 2, "slurm");
  expect_failure(run_program(batch(table, out, {"--engine", "slurm", "--sbatch", "run"})), 2,
                 "--sbatch");
  expect_failure(run_program(batch(table, out, {"--gate", "tshirt.mae_cm<1"})), 2, "no group");
  expect_failure(run_program(batch(table, out, {"--method", "magic"})), 2, "--method");
  expect_failure(run_program(batch(table, out, {"--args", "--garment tshirt"})), 2, "garments");
  expect_failure(run_program({"batch-task", out}), 2, "--shard");
  expect_failure(run_program({"batch-task", out, "--merge"}), 3, "manifest.json");
  EXPECT_FALSE(fs::exists(out / "fits"));
}

}  // namespace
}  // namespace regarment
