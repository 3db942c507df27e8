#include "evaluation/estimates.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/one_line.h"
#include "evaluation/evaluation_table.h"

namespace regarment {
namespace {

constexpr double kLongest = 10'000;  // cm; an estimate may be wildly off, but not without end

void check_columns(const CsvTable& table) {
  for (const std::string_view column : {"scan", "measurement"}) {
    if (!table.has(column)) {
      throw ReadError(table.name() + ": line 1 names no column '" + std::string(column) + "'");
    }
  }
  if (!table.has("estimate_cm") && !table.has("value_cm")) {
    throw ReadError(table.name() + ": line 1 names no column 'estimate_cm' or 'value_cm'");
  }
}

std::optional<double> length(const CsvTable& table, std::size_t row, std::string_view column) {
  const std::optional<double> value = table.number(row, column);
  if (value && std::abs(*value) > kLongest) {
    throw ReadError(table.where(row, column) + ": is beyond 10000 cm; give centimetres");
  }
  return value;
}

std::optional<FoundDimension> estimate_of(const CsvTable& table, std::size_t row) {
  const auto value = length(table, row, table.has("estimate_cm") ? "estimate_cm" : "value_cm");
  if (!value) return std::nullopt;
  FoundDimension out;
  out.value_cm = *value;
  out.low_cm = length(table, row, "low_cm");
  out.high_cm = length(table, row, "high_cm");
  if (out.low_cm.has_value() != out.high_cm.has_value() ||
      (out.low_cm && *out.low_cm > *out.high_cm)) {
    throw ReadError(table.where(row, "low_cm") + ": low_cm and high_cm are no interval");
  }
  out.worn_cm = length(table, row, "worn_cm");
  out.observable = yes_or_no(table, row, "observable").value_or(true);
  return out;
}

bool means(const CsvTable& table, std::size_t row, const TrueDimension& truth) {
  const std::string_view measurement = table.cell(row, "measurement");
  const std::string_view garment = table.cell(row, "template");
  const std::optional<double> layer = table.number(row, "layer");
  return (measurement == truth.measurement || measurement == truth.code) &&
         (garment.empty() || garment == truth.template_name) &&
         (!layer || *layer == static_cast<double>(truth.layer));
}

// Puts one row where it belongs. False when the truth does not know it.
bool place(const CsvTable& table, std::size_t row, const FoundDimension& estimate,
           EvaluatedScan& scan) {
  std::optional<std::size_t> place;
  for (std::size_t d = 0; d < scan.about.dimensions.size(); ++d) {
    if (!means(table, row, scan.about.dimensions[d])) continue;
    if (place) {
      throw ReadError(table.where(row, "measurement") +
                      ": two garments of this scan have it; say which in the column 'template' or "
                      "'layer'");
    }
    place = d;
  }
  if (!place) return false;
  if (scan.found[*place]) {
    throw ReadError(table.where(row, "measurement") + ": is given twice for this scan");
  }
  scan.found[*place] = estimate;
  return true;
}

// A page that is opened must not run what a table says: no other scheme than of the web.
std::string report_of(const CsvTable& table, std::size_t row) {
  std::string address(table.cell(row, "report"));
  const std::size_t colon = address.find(':');
  const bool scheme = colon != std::string::npos && colon < address.find_first_of("/?#");
  const bool web = address.starts_with("https://") || address.starts_with("http://");
  const bool plain = std::none_of(address.begin(), address.end(), [](char c) {
    return static_cast<unsigned char>(c) <= ' ' || c == '\\' || c == 0x7f;
  });
  if (!plain || (scheme && !web))
    throw ReadError(table.where(row, "report") +
                    ": is no address; give https://..., or a path without spaces");
  return address;
}

using RowsOfScan = std::map<std::string, std::vector<std::size_t>>;

// The scans in the order of their first rows, and the rows of each.
std::vector<std::string> scans_of(const CsvTable& table, RowsOfScan& rows) {
  std::vector<std::string> out;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::string scan(table.cell(row, "scan"));
    if (scan.empty()) throw ReadError(table.where(row, "scan") + " is empty");
    const auto [entry, is_new] = rows.try_emplace(scan);
    if (is_new) out.push_back(scan);
    entry->second.push_back(row);
  }
  return out;
}

}  // namespace

std::vector<EvaluatedScan> compare_estimates(const CsvTable& truth,
                                             const std::filesystem::path& truth_folder,
                                             const CsvTable& estimates) {
  check_columns(estimates);
  std::vector<EvaluatedScan> out;
  std::size_t placed = 0;
  RowsOfScan rows;
  const std::vector<std::string> scans = scans_of(estimates, rows);
  for (EvaluationCase& one : cases_of_estimates(truth, truth_folder, scans)) {
    EvaluatedScan scan;
    scan.found.resize(one.dimensions.size());
    scan.about = std::move(one);
    bool any = false;
    for (const std::size_t row : rows[scan.about.scan.string()]) {
      const auto estimate = estimate_of(estimates, row);
      if (estimate && place(estimates, row, *estimate, scan)) any = true, ++placed;
      if (std::string report = report_of(estimates, row); !report.empty()) {
        scan.report = std::move(report);
      }
    }
    if (!any) scan.failure = {"no estimate", 0, "the table has no estimate for this scan"};
    if (!any) scan.found.clear();
    out.push_back(std::move(scan));
  }
  if (placed == 0) {
    throw UsageError(estimates.name() + ": not one row belongs to a scan and measurement of " +
                     truth.name() + "; check its columns 'scan' and 'measurement'");
  }
  return out;
}

}  // namespace regarment
