#include "app/batch_options.h"

#include <CLI/CLI.hpp>

#include "app/every_fit_options.h"
#include "app/one_each.h"
#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

void add_gates(CLI::App& command, std::vector<std::string>& gates) {
  one_each(
      command.add_option("--gate", gates, "A condition such as \"mae_cm<=1.0\"; repeat for more"));
}

}  // namespace

void add_batch_options(CLI::App& batch, BatchArguments& a) {
  batch.add_option("TABLE", a.table, "CSV table of scans, as 'evaluate' reads it");
  batch.add_option("-o,--out", a.out, "Folder of the batch; what is finished in it is kept");
  batch.add_option("--status", a.status, "Say how far the batch in this folder is");
  batch.add_option("--engine", a.engine, "Who does the work: this machine, or Slurm")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  batch
      .add_option("--workers", a.workers,
                  "Fits at once, of one thread each; by default as many as there are cores, or as "
                  "Slurm likes")
      ->check(CLI::Range(1, 10'000));
  batch.add_option("--shard-size", a.shard_size, "Scans of one task of Slurm")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  batch.add_option("--timeout", a.timeout, "Longest time of a fit, s")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  batch.add_flag("--retry", a.retry, "Try scans again that failed or are parked");
  batch.add_option("--scans", a.scans, "Another folder to find scans in");
  batch.add_option("--only", a.only, "Only scans whose name matches, with * and ?");
  add_gates(batch, a.gates);
  batch.add_flag("--dry-run", a.dry_run, "With slurm: write the scripts, submit nothing");
  one_each(batch.add_option(
      "--sbatch", a.sbatch,
      "An option of every sbatch, such as --sbatch=--partition=fit; repeat for more"));
  add_every_fit_options(batch, a.fit_options);
}

void add_batch_task_options(CLI::App& task, BatchTaskArguments& a) {
  task.add_option("DIR", a.folder, "Folder of the batch")->required();
  task.add_option("--shard", a.shard, "Fit what is left of this shard, counted from 0");
  task.add_flag("--merge", a.merge, "Fit what is left of all shards, and sum up");
  add_gates(task, a.gates);
}

void check_batch(const BatchArguments& a) {
  if (a.status) {
    if (a.table || a.out) throw UsageError("--status DIR: takes no TABLE and no --out");
    return;
  }
  if (!a.table || !a.out) {
    throw UsageError("batch: give TABLE and --out DIR, or --status DIR; see 'batch --help'");
  }
  if (a.engine != "slurm" && (a.dry_run || !a.sbatch.empty())) {
    throw UsageError("--dry-run and --sbatch belong to --engine slurm");
  }
  for (const std::string& word : a.sbatch) {
    if (word.starts_with("--") && word.size() > 2) continue;
    throw UsageError("--sbatch: '" + one_line(word, 60) +
                     "' is no option of sbatch; write it as --sbatch=--NAME=VALUE");
  }
}

void check_batch_task(const BatchTaskArguments& a) {
  if (a.merge == a.shard.has_value()) throw UsageError("batch-task: give --shard N or --merge");
  if (!a.merge && !a.gates.empty()) throw UsageError("--gate: belongs to --merge");
}

}  // namespace regarment
