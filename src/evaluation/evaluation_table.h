#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/evaluated_scan.h"
#include "report/csv_table.h"

namespace regarment {

/// The scans a ground-truth table speaks of, in the order of their first rows; a row that means
/// several files gives one each. Beyond the columns of report/ground_truth.h these are read:
/// `worn_cm`, `observable` (true or false) of a row; `labels`, `options` (words between spaces),
/// `garment` (scans of the same one are repeats; else those of one path up to the first point of
/// the file's name are), `kind`, `damage` (words between semicolons), `units`, `up`, `front` (axes
/// between semicolons, any of which is right) of a scan, which need to be said in one of its rows
/// and must not differ between them. `only` is a pattern with * and ? that a scan's name or its
/// file's name must match; empty: all. Throws ReadError naming line and column of what is wrong,
/// and when there are more than 50000 scans; UsageError when nothing is left.
std::vector<EvaluationCase> read_evaluation_table(const CsvTable& table,
                                                  const std::filesystem::path& table_folder,
                                                  const std::optional<std::filesystem::path>& scans,
                                                  const std::string& only);

/// The same for scans whose truth may not be known: those without any value have no dimensions, and
/// their rows need `scan` and `template` alone.
std::vector<EvaluationCase> read_campaign_table(const CsvTable& table,
                                                const std::filesystem::path& table_folder,
                                                const std::optional<std::filesystem::path>& scans,
                                                const std::string& only);

/// The same for a comparison without files: one case per name in `estimated`, which are scans as
/// another table writes them. A name belongs to the truth of the same path or file name, of its
/// stem, or, where it is a stem itself, of the file it is the stem of. Names nobody knows the truth
/// of are left out; scans of the truth that are not estimated come last.
std::vector<EvaluationCase> cases_of_estimates(const CsvTable& table,
                                               const std::filesystem::path& table_folder,
                                               const std::vector<std::string>& estimated);

/// A cell that says true, yes or 1, or false, no or 0; nothing when it is empty or there is no such
/// column. Throws ReadError on anything else.
std::optional<bool> yes_or_no(const CsvTable& table, std::size_t row, std::string_view column);

}  // namespace regarment
