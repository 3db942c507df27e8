#include "batch/submit_batch.h"

#include <cerrno>
#include <chrono>

#include "base/child_process.h"
#include "base/error.h"
#include "base/one_line.h"
#include "batch/batch_state.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kPatience{120};  // with Slurm
constexpr std::chrono::milliseconds kLook{100};
constexpr int kNoSuchCommand = 127;
constexpr std::size_t kLongestLine = 500;

std::vector<std::size_t> shards_to_do(const Manifest& manifest, const BatchState& state) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < manifest.shards(); ++i) {
    const auto [first, end] = manifest.shard(i);
    bool ended = true;
    for (std::size_t k = first; k < end; ++k) ended = ended && state.scans[k].has_value();
    if (!ended) out.push_back(i);
  }
  return out;
}

}  // namespace

void write_slurm_scripts(const BatchFolder& folder, const Manifest& manifest,
                         const SlurmOptions& options) {
  std::error_code error;
  fs::create_directories(folder.place() / "log", error);
  if (error) throw_write_error(folder.place() / "log", error.value());
  const auto shards = shards_to_do(manifest, batch_state(folder, manifest));
  if (shards.empty()) {
    fs::remove(folder.place() / "array.sbatch", error);
  } else {
    folder.write("array.sbatch", array_script(manifest, shards, options));
  }
  folder.write("merge.sbatch", merge_script(manifest, options));
  folder.write("submit.sh", submit_script(!shards.empty(), options));
}

std::vector<std::string> submit_batch(const BatchFolder& folder, const Progress& progress) {
  // A child's standard output goes nowhere, its standard error to us.
  ChildProcess child({"/bin/sh", "-c", "exec /bin/sh \"$0\" 1>&2", folder.place() / "submit.sh"},
                     {kPatience, 0, 0});
  std::vector<std::string> lines;
  ChildEnd end;
  for (bool over = false; !over;) {
    progress.report("submit", 0);
    wait_for_children({&child}, kLook);
    child.look_after();
    over = child.ended(end);
    for (const std::string& line : child.take_lines()) {
      lines.push_back(one_line(line, kLongestLine));
    }
  }
  if (end.status == kNoSuchCommand) {
    throw UsageError("--engine slurm: " + end.last_line +
                     "; run it where Slurm's commands are, or use --dry-run or --engine local");
  }
  if (end.status != 0) {
    throw TemporaryError("Slurm took no batch (" + (end.timed_out ? "no answer" : end.last_line) +
                         "); see " + (folder.place() / "submit.sh").string() +
                         ", run the command again");
  }
  progress.report("submit", 1);
  return lines;
}

}  // namespace regarment
