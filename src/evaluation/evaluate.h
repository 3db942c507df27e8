#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "evaluation/evaluation.h"

namespace regarment {

/// What is evaluated, and how.
struct EvaluateOptions {
  std::filesystem::path table, out;
  std::optional<std::filesystem::path> scans;      // another folder to find scans in
  std::optional<std::filesystem::path> estimates;  // compare these instead of fitting
  std::optional<std::filesystem::path> baseline;   // an evaluation.json of before
  std::string only;                                // pattern of scans' names; empty: all
  std::vector<std::string> gates;
  std::vector<std::string> fit_options;  // for every fit, as on the command line
  std::filesystem::path program;         // absolute; `program fit ...` makes a fit
  int jobs = 1;                          // fits at once, >= 1
  int threads = 1;                       // of each fit
  int timeout = 1800;                    // of each fit, s
  bool force = false;                    // make every fit again
  bool timing = true;                    // false: no times, so that two runs give the same bytes
  /// Throws UsageError when the program would not take this command, or take it for other garments
  /// than these; asked before any fit. Empty: nothing is asked.
  std::function<void(const std::vector<std::string>& command,
                     const std::vector<std::string>& garments)>
      check_fit;
};

/// Fits every scan of the table in a process of its own, or reads the estimates, sums up, and
/// writes evaluation.json, evaluation.csv and evaluation.html into the folder. Fits that are there
/// and made by the same program with the same options of the same bytes are kept; a fit that fails
/// is a result. Throws UsageError and ReadError about what is asked, before any fit; Stopped when
/// `progress` says so, with all children gone and finished fits kept. Failed gates are no error:
/// the evaluation says so. `evaluation_json` of what is returned is what was written.
Evaluation evaluate(const EvaluateOptions& options, const Progress& progress);

}  // namespace regarment
