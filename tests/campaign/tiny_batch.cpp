// A batch by Slurm whose fits are the tiny ones of tests/jobs, so that what is tried is the engine.
//
//   tiny_batch submit HOME JOBS SHARD_SIZE  makes scans, table and batch in HOME, and submits them
//   tiny_batch batch-task DIR ...           what the scripts of a batch call
//   tiny_batch count HOME JOBS              says what became of the jobs; fails unless all is right

#include <cstdio>
#include <fstream>

#include "base/error.h"
#include "batch/batch_plan.h"
#include "batch/batch_state.h"
#include "batch/merge_batch.h"
#include "batch/run_batch.h"
#include "batch/submit_batch.h"
#include "support/folders.h"
#include "tiny_work.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

fs::path batch_of(const fs::path& home) { return home / "batch"; }

fs::path write_campaign(const fs::path& home, int jobs) {
  fs::create_directory(home / "scans");
  std::ofstream table(home / "table.csv");
  table << "scan,layer,template,measurement,value_cm\n";
  for (int i = 0; i < jobs; ++i) {
    const std::string file = "scans/" + tiny_name(i) + ".ply";
    std::ofstream(home / file) << tiny_scan(i);
    table << file << ",1,skirt,length," << tiny_length(i) << "\n";
  }
  return home / "table.csv";
}

int submit(const fs::path& home, int jobs, int shard_size) {
  BatchOptions options;
  options.table = write_campaign(home, jobs);
  options.program = write_tiny_program(home);
  options.shard_size = static_cast<std::size_t>(shard_size);
  const Manifest manifest = plan_batch(options, {});
  const BatchFolder folder = prepare_batch(batch_of(home), manifest, false);
  write_slurm_scripts(folder, manifest,
                      {fs::read_symlink("/proc/self/exe"), folder.place(), home, {}, {}, 0});
  for (const std::string& line : submit_batch(folder, {})) std::puts(line.c_str());
  return 0;
}

int task(const Words& words) {
  const BatchFolder folder(words[1]);
  const Manifest manifest = folder.manifest();
  const fs::path program = folder.place().parent_path() / "tiny";
  if (words[2] == "--shard") {
    run_shard(folder, manifest, std::stoul(words[3]), program, {});
    return 0;
  }
  run_all(folder, manifest, program, 1, {});
  merge_batch(folder, manifest, {}, 1, {});
  return 0;
}

int count(const fs::path& home, int jobs) {
  const BatchFolder folder(batch_of(home));
  const Manifest manifest = folder.manifest();
  const BatchState state = batch_state(folder, manifest);
  std::map<std::string, fs::path> right;
  for (const BatchScan& scan : manifest.scans) {
    if (is_tiny_result(folder.fit(scan.name), tiny_number(scan.name))) {
      right[scan.name] = folder.fit(scan.name);
    }
  }
  const auto all = static_cast<std::size_t>(jobs);
  const std::size_t folders = names_in(folder.place() / "fits").size();
  std::printf("%zu ended, %zu succeeded, %zu lost, %zu folders; results %s\n", state.ended(),
              state.succeeded, all - right.size(), folders, tiny_digest(right).c_str());
  return state.succeeded == all && right.size() == all && folders == all ? 0 : 1;
}

int run(const Words& words) {
  try {
    if (words.size() == 4 && words[0] == "submit") {
      return submit(words[1], std::stoi(words[2]), std::stoi(words[3]));
    }
    if (words.size() >= 3 && words[0] == "batch-task") return task(words);
    if (words.size() == 3 && words[0] == "count") return count(words[1], std::stoi(words[2]));
    std::fputs(
        "usage: tiny_batch submit HOME JOBS SHARD_SIZE | batch-task DIR ... | count HOME JOBS\n",
        stderr);
    return 2;
  } catch (const TemporaryError& error) {
    std::fprintf(stderr, "tiny_batch: %s\n", error.what());
    return 75;
  } catch (const Error& error) {
    std::fprintf(stderr, "tiny_batch: %s\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) { return regarment::run({argv + 1, argv + argc}); }
