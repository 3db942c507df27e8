#pragma once

#include <string>

#include "report/result.h"

namespace regarment {

/// The verdict of a report for pages and programs, JSON:
///   {"level": "good" | "look" | "poor", "title", "headline", "against_truth",
///    "checks": [{"level", "name", "found", "threshold", "advice"}, ...], "warnings": [..]}
/// Texts are as the report has them, not escaped.
std::string verdict_json(const Result& result);

}  // namespace regarment
