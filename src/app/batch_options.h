#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/speech.h"

namespace CLI {
class App;
}

namespace regarment {

/// regarment batch TABLE --out DIR, or regarment batch --status DIR
struct BatchArguments {
  Speech speech;
  std::optional<std::filesystem::path> table, out, scans;
  std::optional<std::filesystem::path> status;  // say how far this batch is, and nothing else
  std::string engine = "local";                 // or "slurm"
  std::string only;
  std::vector<std::string> gates;
  std::vector<std::string> fit_options;  // words for every fit, checked: "--seed", "7"
  std::vector<std::string> sbatch;       // words for every sbatch: "--partition=fit"
  int workers = 0;     // fits at once; 0: as many as there are cores, or as Slurm likes
  int timeout = 1800;  // of each fit, s
  std::size_t shard_size = 25;
  bool retry = false, dry_run = false;
};

/// regarment batch-task DIR --shard N | --merge
struct BatchTaskArguments {
  Speech speech;
  std::filesystem::path folder;
  std::optional<std::size_t> shard;
  bool merge = false;
  std::vector<std::string> gates;
};

/// Declare the options, but for those of Speech.
void add_batch_options(CLI::App& batch, BatchArguments& a);
void add_batch_task_options(CLI::App& task, BatchTaskArguments& a);

/// Throw UsageError for what does not go together.
void check_batch(const BatchArguments& a);
void check_batch_task(const BatchTaskArguments& a);

}  // namespace regarment
