#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/evaluated_scan.h"
#include "report/csv_table.h"

namespace regarment {

/// What another program, or an earlier evaluation, found for the scans of a truth table. Columns of
/// `estimates`: `scan`, `measurement` (name or code) and `estimate_cm` (or `value_cm`); `layer`,
/// `template`, `low_cm`, `high_cm`, `worn_cm` and `observable` may be there, and `report`, the
/// address of the scan's report, seen from the page. Rows without an estimate, and of scans or
/// garments the truth does not know, are skipped. Scans without any estimate count as failed.
/// Throws ReadError naming line and column, also when a row may mean two dimensions or one is given
/// twice; UsageError when not one row has a truth.
std::vector<EvaluatedScan> compare_estimates(const CsvTable& truth,
                                             const std::filesystem::path& truth_folder,
                                             const CsvTable& estimates);

}  // namespace regarment
