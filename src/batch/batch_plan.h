#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "batch/manifest.h"
#include "evaluation/evaluated_scan.h"

namespace regarment {

/// What a batch is made of.
struct BatchOptions {
  std::filesystem::path table;                 // as `evaluate` reads it
  std::optional<std::filesystem::path> scans;  // another folder to find scans in
  std::string only;                            // pattern of scans' names; empty: all
  std::vector<std::string> fit_options;        // for every fit, as on the command line
  std::filesystem::path program;               // absolute; `program fit ...` makes a fit
  int timeout = 1800;                          // of each fit, s
  std::size_t shard_size = 25;                 // scans a shard, >= 1
  std::vector<std::string> gates;              // for the merge, checked before any fit
  /// As in EvaluateOptions.
  std::function<void(const std::vector<std::string>& command,
                     const std::vector<std::string>& garments)>
      check_fit;
};

/// Reads the table and hashes every file. Throws ReadError and UsageError about what is asked,
/// Stopped when `progress` says so.
Manifest plan_batch(const BatchOptions& options, const Progress& progress);

/// What the table says of the scans of a manifest, in its order. Throws UsageError when the table
/// is no longer the one the batch was planned with.
std::vector<EvaluationCase> cases_of(const Manifest& manifest);

/// Throws UsageError unless `program` and the table are those the batch was planned with.
void check_unchanged(const Manifest& manifest, const std::filesystem::path& program);

}  // namespace regarment
