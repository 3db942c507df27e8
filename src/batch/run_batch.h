#pragma once

#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "batch/batch_folder.h"
#include "batch/manifest.h"

namespace regarment {

/// Makes the folder of a batch ready for this plan: what an earlier run finished for the same scans
/// in the same way is kept, the rest is forgotten; with `retry` failed and parked scans are as
/// well. Throws as BatchFolder::create, and TemporaryError when others are at work there.
BatchFolder prepare_batch(const std::filesystem::path& place, const Manifest& manifest, bool retry);

/// Fits what is left of a whole batch in this process's children, `workers` at once. Throws as
/// run_scans does, and UsageError when table or program have changed since the plan.
void run_all(const BatchFolder& folder, const Manifest& manifest,
             const std::filesystem::path& program, int workers, const Progress& progress);

/// The same for one shard, one fit at a time, beside others at other shards.
void run_shard(const BatchFolder& folder, const Manifest& manifest, std::size_t shard,
               const std::filesystem::path& program, const Progress& progress);

}  // namespace regarment
