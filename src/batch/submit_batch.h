#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "batch/batch_folder.h"
#include "batch/slurm_scripts.h"

namespace regarment {

/// Writes array.sbatch (unless every scan has ended), merge.sbatch and submit.sh into the folder.
void write_slurm_scripts(const BatchFolder& folder, const Manifest& manifest,
                         const SlurmOptions& options);

/// Runs submit.sh. Returns the lines it said, the last of which names the jobs. Throws UsageError
/// when there is no sbatch, TemporaryError with what Slurm said when it took nothing, Stopped.
std::vector<std::string> submit_batch(const BatchFolder& folder, const Progress& progress);

}  // namespace regarment
