#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/evaluated_scan.h"

namespace regarment {

/// The fit of one scan as a command, and what its result depends on.
struct FitJob {
  std::vector<std::string> command;  // program, then its arguments
  std::filesystem::path folder;      // where the result goes
  std::string key;                   // one text per program, options, garments, truth and labels
};

/// What all fits of an evaluation share.
struct FitJobOptions {
  std::filesystem::path program;  // absolute
  std::filesystem::path table;    // the ground truth
  std::filesystem::path fits;     // folder of the results
  std::vector<std::string> options;
  int threads = 1;     // of each fit; no part of the key
  bool timing = true;  // false: --no-timing
};

/// The words after `fit` that say what is fitted and how: all but the program, --out and --force.
std::vector<std::string> fit_words(const EvaluationCase& one, const FitJobOptions& options);

/// `program_sha256`: of the program's bytes.
FitJob make_fit_job(const EvaluationCase& one, const FitJobOptions& options,
                    const std::string& program_sha256);

/// Whether the folder holds a whole result of this very job and of the scan's bytes as they are.
bool is_finished(const FitJob& job, const EvaluationCase& one);

/// Notes in the folder of a fit that just succeeded what it depends on.
void mark_finished(const FitJob& job);

}  // namespace regarment
