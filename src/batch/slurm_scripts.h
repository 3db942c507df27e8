#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "batch/manifest.h"

namespace regarment {

/// What the scripts for Slurm are written of.
struct SlurmOptions {
  std::filesystem::path program;   // absolute, reachable from every node, as all paths here
  std::filesystem::path folder;    // of the batch, absolute
  std::filesystem::path here;      // where relative paths among the options of fits begin, absolute
  std::vector<std::string> gates;  // of the merge
  std::vector<std::string> words;  // for every sbatch: "--partition=fit"
  int at_once = 0;                 // tasks at once; 0: as many as Slurm likes
};

/// The shards as Slurm writes them: "0-3,7". They ascend; empty gives "".
std::string array_indices(const std::vector<std::size_t>& shards);

/// A job array with a task for each of these shards (at least one). A task that was ended by a
/// signal, or met a temporary failure, leaves with 75.
std::string array_script(const Manifest& manifest, const std::vector<std::size_t>& shards,
                         const SlurmOptions& options);

/// The job that comes after all tasks: fits what killed ones left, and merges.
std::string merge_script(const Manifest& manifest, const SlurmOptions& options);

/// Submits both and prints "array JOB, merge JOB" as its last line; without an array, the merge.
std::string submit_script(bool with_array, const SlurmOptions& options);

}  // namespace regarment
