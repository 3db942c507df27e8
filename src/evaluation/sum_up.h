#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "evaluation/baseline.h"
#include "evaluation/evaluation.h"
#include "evaluation/evaluation_folder.h"
#include "evaluation/gate.h"

namespace regarment {

/// The groups there will be, before anything is fitted; for check_gate_groups.
std::vector<GroupStatistics> expected_groups(const std::vector<EvaluationCase>& cases);

/// Makes everything else of the `scans` an evaluation holds: groups, gates, what differs from the
/// baseline, pictures of the worst scans, whose fits stand in the folder; and writes
/// evaluation.csv, evaluation.html and evaluation.json there. Throws Stopped when `progress` says
/// so.
void sum_up(Evaluation& evaluation, const std::vector<Gate>& gates,
            const std::optional<Baseline>& baseline, const EvaluationFolder& folder,
            const Progress& progress);

}  // namespace regarment
