#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands.h"
#include "app/evaluation_verdict.h"
#include "app/every_fit_options.h"
#include "base/error.h"
#include "base/one_line.h"
#include "batch/batch_plan.h"
#include "batch/batch_state.h"
#include "batch/merge_batch.h"
#include "batch/run_batch.h"
#include "batch/submit_batch.h"
#include "evaluation/evaluation_json.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestLine = 4096;

fs::path this_program() { return fs::read_symlink("/proc/self/exe"); }

BatchOptions batch_options(const BatchArguments& a) {
  BatchOptions out;
  out.table = *a.table;
  out.scans = a.scans;
  out.only = a.only;
  out.fit_options = a.fit_options;
  out.program = this_program();
  out.timeout = a.timeout;
  out.shard_size = a.shard_size;
  out.gates = a.gates;
  out.check_fit = check_fit_command;
  return out;
}

void merge(const BatchFolder& folder, const Manifest& manifest,
           const std::vector<std::string>& gates, int workers, Console& console) {
  const Evaluation evaluation = merge_batch(folder, manifest, gates, workers, console.progress());
  const fs::path page = folder.place() / "evaluation.html";
  console.say(one_line(page.string(), kLongestLine));
  if (console.wants_json()) console.answer(evaluation_json(evaluation));
  judge_evaluation(evaluation, page, console);
}

void run_by_slurm(const BatchArguments& a, const BatchFolder& folder, const Manifest& manifest,
                  Console& console) {
  SlurmOptions how{this_program(), folder.place(), fs::current_path(),
                   a.gates,        a.sbatch,       a.workers};
  write_slurm_scripts(folder, manifest, how);
  std::vector<std::string> lines;
  if (!a.dry_run) lines = submit_batch(folder, console.progress());
  const std::string script = (folder.place() / "submit.sh").string();
  if (console.wants_json()) {
    const nlohmann::ordered_json json = {
        {"script", one_line(script, kLongestLine)}, {"submitted", !a.dry_run}, {"said", lines}};
    console.answer(json.dump(2) + "\n");
  }
  for (const std::string& line : lines) console.say(line);
  if (a.dry_run) console.say(one_line(script, kLongestLine));
}

void say_status(const fs::path& place, Console& console) {
  const BatchFolder folder(place);
  const Manifest manifest = folder.manifest();
  const BatchState state = batch_state(folder, manifest);
  console.answer(console.wants_json() ? state_json(manifest, state) : state_text(manifest, state));
}

}  // namespace

void run_batch(const BatchArguments& a, Console& console) {
  if (a.status) return say_status(*a.status, console);
  const Manifest manifest = plan_batch(batch_options(a), console.progress());
  const BatchFolder folder = prepare_batch(*a.out, manifest, a.retry);
  if (a.engine == "slurm") return run_by_slurm(a, folder, manifest, console);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int workers = a.workers > 0 ? a.workers : cores;
  run_all(folder, manifest, this_program(), workers, console.progress());
  merge(folder, manifest, a.gates, workers, console);
}

void run_batch_task(const BatchTaskArguments& a, Console& console) {
  const BatchFolder folder(a.folder);
  const Manifest manifest = folder.manifest();
  if (a.shard) return run_shard(folder, manifest, *a.shard, this_program(), console.progress());
  run_all(folder, manifest, this_program(), 1, console.progress());
  merge(folder, manifest, a.gates, 1, console);
}

}  // namespace regarment
