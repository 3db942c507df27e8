#pragma once

#include <string>

#include "evaluation/evaluation.h"

namespace regarment {

/// The text of evaluation.json, valid by schemas/evaluation.schema.json: figures of every group by
/// the names of named_statistics.h, gates, baseline, and each scan with its dimensions.
std::string evaluation_json(const Evaluation& evaluation);

}  // namespace regarment
