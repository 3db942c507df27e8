#pragma once

#include <filesystem>
#include <string>

namespace regarment {

/// The rows of a ground-truth table that speak of one scan, as a table of that scan alone under
/// another name. `scan` is what the sender calls it; where the table has no column `scan`, or names
/// one scan only, all rows do. Throws HttpProblem 422 "bad_ground_truth".
std::string truth_of_scan(const std::string& table, const std::string& scan,
                          const std::string& name);

}  // namespace regarment
