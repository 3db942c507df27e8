#include "report/ground_truth.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/one_line.h"
#include "report/files.h"
#include "report/text.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr double kLongest = 10.0;  // m; no garment has a longer dimension
constexpr double kMetres = 0.01;   // m in a centimetre

// The first of two columns that has something in this row.
std::string_view filled(const CsvTable& table, std::size_t row, std::string_view column,
                        std::string_view also) {
  return table.cell(row, column).empty() && !table.cell(row, also).empty() ? also : column;
}

std::optional<double> metres(const CsvTable& table, std::size_t row, std::string_view column,
                             double lowest) {
  std::optional<double> value = table.number(row, column);
  if (!value) return value;
  *value *= kMetres;
  if (*value < lowest || *value > kLongest) {
    throw ReadError(table.where(row, column) + ": " + std::string(table.cell(row, column)) +
                    " is outside " + fixed_text(lowest / kMetres, 1) + " to " +
                    fixed_text(kLongest / kMetres, 0) + " cm; give centimetres");
  }
  return value;
}

std::optional<int> layer_of(const CsvTable& table, std::size_t row) {
  const std::optional<double> layer = table.number(row, "layer");
  if (!layer) return std::nullopt;
  if (*layer < 1 || *layer > 100 || *layer != std::floor(*layer)) {
    throw ReadError(table.where(row, "layer") + ": layers are 1 (outermost), 2, 3, ...");
  }
  return static_cast<int>(*layer);
}

std::optional<TruthRow> truth_row(const CsvTable& table, std::size_t i) {
  const auto value_column = filled(table, i, "value_cm", "ground_truth_cm");
  const auto published_column = filled(table, i, "published_cm", "published_estimate_cm");
  TruthRow row;
  row.line = table.line(i);
  row.scan = table.cell(i, "scan");
  row.layer = layer_of(table, i);
  row.template_name = table.cell(i, "template");
  row.measurement = table.cell(i, "measurement");
  row.published = metres(table, i, published_column, 0.0);
  row.tol_minus = metres(table, i, "tol_minus_cm", 0.0);
  row.tol_plus = metres(table, i, "tol_plus_cm", 0.0);
  const std::optional<double> value = metres(table, i, value_column, 0.001);
  for (const std::string_view column : {"scan", "measurement"}) {
    if (table.cell(i, column).empty()) throw ReadError(table.where(i, column) + " is empty");
  }
  if (!value) return std::nullopt;
  row.value = *value;
  return row;
}

// Device and inode, by which a file is the same whatever it is called; nothing where there is none.
std::optional<std::pair<std::uint64_t, std::uint64_t>> file_number(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return std::pair<std::uint64_t, std::uint64_t>(status.st_dev, status.st_ino);
}

GarmentAnalysis* garment_of(const TruthRow& row, Analysis& analysis) {
  std::vector<GarmentAnalysis*> matches;
  for (GarmentAnalysis& garment : analysis.garments) {
    if (row.template_name.empty() || row.template_name == garment.template_name) {
      matches.push_back(&garment);
    }
  }
  if (matches.size() == 1 && (!row.template_name.empty() || !row.layer)) return matches.front();
  for (GarmentAnalysis* garment : matches) {
    if (row.layer && garment->layer == *row.layer) return garment;
  }
  return nullptr;
}

Measurement& measurement_of(const TruthRow& row, const std::string& table,
                            GarmentAnalysis& garment) {
  const std::string where = table + ": line " + std::to_string(row.line) + ": ";
  for (Measurement& measurement : garment.measurements) {
    if (measurement.name != row.measurement && measurement.code != row.measurement) continue;
    if (measurement.truth) {
      throw ReadError(where + "'" + measurement.name + "' of this garment is given twice");
    }
    return measurement;
  }
  throw ReadError(where + "the template " + garment.template_name + " has no measurement '" +
                  one_line(row.measurement) + "'; see 'regarment templates " +
                  garment.template_name + "'");
}

}  // namespace

std::vector<TruthRow> truth_rows(const CsvTable& table) {
  for (const std::string_view column : {"scan", "measurement"}) {
    if (!table.has(column)) {
      throw ReadError(table.name() + ": line 1 names no column '" + std::string(column) + "'");
    }
  }
  if (!table.has("value_cm") && !table.has("ground_truth_cm")) {
    throw ReadError(table.name() + ": line 1 names no column 'value_cm'");
  }
  std::vector<TruthRow> rows;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (auto row = truth_row(table, i)) rows.push_back(std::move(*row));
  }
  return rows;
}

std::vector<TruthRow> garment_rows(const CsvTable& table) {
  for (const std::string_view column : {"scan", "template"}) {
    if (!table.has(column)) {
      throw ReadError(table.name() + ": line 1 names no column '" + std::string(column) + "'");
    }
  }
  std::vector<TruthRow> rows;
  for (std::size_t i = 0; i < table.size(); ++i) {
    TruthRow row;
    row.line = table.line(i);
    row.scan = table.cell(i, "scan");
    row.layer = layer_of(table, i);
    row.template_name = table.cell(i, "template");
    for (const std::string_view column : {"scan", "template"}) {
      if (table.cell(i, column).empty()) throw ReadError(table.where(i, column) + " is empty");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<TruthRow> rows_of_scan(const std::vector<TruthRow>& rows, const fs::path& table_folder,
                                   const fs::path& scan) {
  return TruthIndex(rows, table_folder).rows_of(scan);
}

TruthIndex::TruthIndex(const std::vector<TruthRow>& rows, const fs::path& table_folder)
    : rows_(rows) {
  std::map<std::string, Indices> by_scan;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    by_scan[rows[i].scan].push_back(i);
    by_name_[fs::path(rows[i].scan).filename().string()].push_back(i);
  }
  for (const auto& [written, indices] : by_scan) {
    const auto number = file_number(table_folder / written);
    if (!number) continue;
    Indices& all = by_file_[*number];
    all.insert(all.end(), indices.begin(), indices.end());
    std::sort(all.begin(), all.end());
  }
}

// This very file, else its name, else its longest stem that is named.
const TruthIndex::Indices* TruthIndex::find(const fs::path& scan) const {
  if (const auto number = file_number(scan)) {
    const auto found = by_file_.find(*number);
    if (found != by_file_.end()) return &found->second;
  }
  for (fs::path name = scan.filename();; name = name.stem()) {
    const auto found = by_name_.find(name.string());
    if (found != by_name_.end()) return &found->second;
    if (!name.has_extension()) return nullptr;
  }
}

std::vector<TruthRow> TruthIndex::rows_of(const fs::path& scan) const {
  std::vector<TruthRow> out;
  const Indices* found = find(scan);
  if (found == nullptr) return out;
  for (const std::size_t i : *found) out.push_back(rows_[i]);
  return out;
}

void apply_ground_truth(const std::vector<TruthRow>& rows, const std::string& table_name,
                        Analysis& analysis) {
  bool any = false;
  for (const TruthRow& row : rows) {
    GarmentAnalysis* garment = garment_of(row, analysis);
    if (garment == nullptr) continue;
    Measurement& measurement = measurement_of(row, table_name, *garment);
    measurement.truth = row.value;
    measurement.published = row.published;
    measurement.tol_minus = row.tol_minus;
    measurement.tol_plus = row.tol_plus;
    any = true;
  }
  if (!any) {
    throw UsageError(table_name + ": no row belongs to a garment asked for with --garment; " +
                     "check its columns 'template' and 'layer'");
  }
}

std::vector<TruthRow> read_ground_truth(const fs::path& table, const fs::path& scan) {
  const std::string name = table.filename().string();
  const CsvTable cells = CsvTable::parse(read_file(table, (16u << 20) + 1), name);
  std::vector<TruthRow> rows = rows_of_scan(truth_rows(cells), table.parent_path(), scan);
  if (rows.empty()) {
    throw UsageError(name + ": no row is about the scan " + scan.filename().string() +
                     "; its column 'scan' must hold the file's path, name or stem");
  }
  return rows;
}

}  // namespace regarment
