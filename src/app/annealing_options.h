#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/analyze.h"
#include "app/command_line.h"

namespace CLI {
class App;
}

namespace regarment {

/// Declares the options of --method annealing.
void add_annealing_options(CLI::App& fit, AnnealingArguments& a);

/// Puts them where the analysis reads them.
void apply_annealing(const AnnealingArguments& a, AnalyzeOptions& how);

/// Those chosen away from the defaults, name without dashes and value; a switch has an empty value.
std::vector<std::pair<std::string, std::string>> chosen_annealing(const AnnealingArguments& a);

/// All of them with the value they have; a switch is "yes" when it is thrown, else "no".
std::vector<std::pair<std::string, std::string>> every_annealing(const AnnealingArguments& a);

}  // namespace regarment
