#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/analysis.h"
#include "report/csv_table.h"

namespace regarment {

/// One known dimension of one garment in one scan. Lengths in metres.
struct TruthRow {
  std::size_t line = 0;       // of the table, for messages
  std::string scan;           // as written: a path relative to the table, a file name or a stem
  std::optional<int> layer;   // 1 = outermost
  std::string template_name;  // may be empty
  std::string measurement;    // name or code
  double value = 0.0;         // > 0, the flat garment
  std::optional<double> published, tol_minus, tol_plus;  // tolerances >= 0
};

/// Reads the rows of a ground-truth table by column name: `scan`, `measurement` and `value_cm` (or
/// `ground_truth_cm`) must be there; `layer`, `template`, `published_cm` (or
/// `published_estimate_cm`), `tol_minus_cm` and `tol_plus_cm` may be; others are ignored.
/// A row without a value is skipped. Throws ReadError naming line and column.
std::vector<TruthRow> truth_rows(const CsvTable& table);

/// Who wears what, for tables that may say nothing of sizes: every row as one without measurement
/// and value. `scan` and `template` must be there and filled. Throws ReadError naming line and
/// column.
std::vector<TruthRow> garment_rows(const CsvTable& table);

/// The rows that speak of the scan file at `scan`. A row does so when its `scan` is that path seen
/// from `table_folder`, else the file's name, else the name without one or more extensions
/// ("skirt-1" for skirt-1.mesh.ply); only the nearest of these kinds counts.
std::vector<TruthRow> rows_of_scan(const std::vector<TruthRow>& rows,
                                   const std::filesystem::path& table_folder,
                                   const std::filesystem::path& scan);

/// The same for many scans of one table: each file the table names is looked at once.
class TruthIndex {
 public:
  /// Keeps `rows` by reference.
  TruthIndex(const std::vector<TruthRow>& rows, const std::filesystem::path& table_folder);
  std::vector<TruthRow> rows_of(const std::filesystem::path& scan) const;

 private:
  using Indices = std::vector<std::size_t>;  // into rows_, ascending
  const Indices* find(const std::filesystem::path& scan) const;

  const std::vector<TruthRow>& rows_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, Indices> by_file_;  // device and inode
  std::map<std::string, Indices> by_name_;                              // of the file, as written
};

/// Writes truth, tolerances and published estimates into the measurements. A row belongs to the
/// garment of its template (of its layer where two share the template, or where no template is
/// named); rows of garments that were not asked for are left out. Throws ReadError on a measurement
/// the garment does not have or that is given twice, UsageError when no row belongs to any garment.
void apply_ground_truth(const std::vector<TruthRow>& rows, const std::string& table_name,
                        Analysis& analysis);

/// The rows of a table file that speak of the scan file at `scan`. Throws ReadError when the table
/// cannot be read or is larger than 16 MiB, UsageError when it says nothing about this scan.
std::vector<TruthRow> read_ground_truth(const std::filesystem::path& table,
                                        const std::filesystem::path& scan);

}  // namespace regarment
