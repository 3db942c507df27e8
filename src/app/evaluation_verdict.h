#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "evaluation/evaluation.h"

namespace regarment {

/// What an evaluation that is written means for the exit status. Throws GateError when gates
/// failed, each with its line; else NoGarmentError when scans came to no result, unless one of the
/// gates speaks of failures.
void judge_evaluation(const Evaluation& evaluation, const std::filesystem::path& page,
                      Console& console);

}  // namespace regarment
