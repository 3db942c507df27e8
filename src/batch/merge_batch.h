#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "batch/batch_folder.h"
#include "evaluation/evaluation.h"

namespace regarment {

/// Sums up a batch whose scans have all ended, as `evaluate` does, into evaluation.html, .json and
/// .csv of its folder, beside measurements.csv: failed and parked scans are failures. Up to
/// `workers` scans are compared with their truth at once, which changes no byte. Throws
/// TemporaryError when scans have not ended; UsageError when the table has changed, or for gates as
/// parse_gate and check_gate_groups do; Stopped.
Evaluation merge_batch(const BatchFolder& folder, const Manifest& manifest,
                       const std::vector<std::string>& gates, int workers,
                       const Progress& progress);

}  // namespace regarment
