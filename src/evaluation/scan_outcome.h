#pragma once

#include <filesystem>

#include "evaluation/child_pool.h"
#include "evaluation/evaluated_scan.h"

namespace regarment {

/// A fit that came to no result. `timeout` is what it had, s.
EvaluatedScan failed_scan(const EvaluationCase& about, const ChildEnd& end, long timeout);

/// A scan that has no result, for this reason.
EvaluatedScan scan_without_result(const EvaluationCase& about, ScanFailure failure);

/// What the folder of a finished fit says about the scan, and how its labels agree with the true
/// ones. A folder or labels that cannot be read make a failed scan.
EvaluatedScan finished_scan(const EvaluationCase& about, const std::filesystem::path& folder);

/// What an exit status means: "time-out", "crash", "unreadable or no person", ...
std::string failure_kind(const ChildEnd& end);

}  // namespace regarment
