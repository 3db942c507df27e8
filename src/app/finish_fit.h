#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/analyze.h"
#include "analysis/scan_state.h"
#include "app/command_line.h"
#include "app/console.h"

namespace regarment {

/// What a fit works on, whether it was read and prepared just now or stored by an earlier one.
struct FitMaterial {
  ScanState state;
  std::string stored;  // the bytes `state` was read from, for the result
  bool refit = false;
  std::vector<StageTime> times;  // so far
};

/// How many threads a fit may use.
int thread_count(const FitArguments& a);

/// The templates of a fit. Throws as find_template.
std::vector<GarmentTemplate> templates_of(const FitArguments& a);

/// How to analyse, but for what a placement file says. Throws UsageError for help that does not
/// suit the templates.
AnalyzeOptions analyze_options(const FitArguments& a,
                               const std::vector<GarmentTemplate>& templates);

/// Analyses, judges by the truth that `add_truth` knows, writes the folder and answers.
void finish_fit(const FitArguments& a, const std::vector<GarmentTemplate>& templates,
                AnalyzeOptions how, FitMaterial material,
                const std::function<void(Analysis&)>& add_truth, Console& console);

}  // namespace regarment
