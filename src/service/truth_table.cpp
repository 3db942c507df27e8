#include "service/truth_table.h"

#include <set>

#include "base/error.h"
#include "http/problem.h"
#include "report/csv_table.h"
#include "report/ground_truth.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr int kDigits = 6;  // of a centimetre: more than any tape has

std::string cm(std::optional<double> metres) {
  return metres ? fixed_text(*metres * 100, kDigits) : "";
}

// A table of one scan need not name it.
CsvTable with_scan(const CsvTable& table) {
  if (table.has("scan")) return table;
  std::string head = "scan", rows;
  std::vector<const char*> columns;
  for (const char* column :
       {"layer", "template", "measurement", "value_cm", "ground_truth_cm", "published_cm",
        "published_estimate_cm", "tol_minus_cm", "tol_plus_cm"})
    if (table.has(column)) columns.push_back(column), head.append(",").append(column);
  for (std::size_t i = 0; i < table.size(); ++i) {
    rows += "scan";
    for (const char* column : columns) rows.append(",").append(csv_exact(table.cell(i, column)));
    rows += "\n";
  }
  return CsvTable::parse(head + "\n" + rows, table.name());
}

std::vector<TruthRow> rows_for(const std::string& table, const std::string& scan) {
  std::vector<TruthRow> rows = truth_rows(with_scan(CsvTable::parse(table, "ground_truth")));
  std::set<std::string> scans;
  for (const TruthRow& row : rows) scans.insert(row.scan);
  if (scans.size() <= 1) return rows;
  return rows_of_scan(rows, "", scan);
}

}  // namespace

std::string truth_of_scan(const std::string& table, const std::string& scan,
                          const std::string& name) try {
  const std::vector<TruthRow> rows = rows_for(table, scan);
  if (rows.empty())
    throw ReadError("ground_truth: no row speaks of this scan; give the scan's name in 'scan'");
  std::string out =
      "scan,layer,template,measurement,value_cm,published_cm,tol_minus_cm,tol_plus_cm\n";
  for (const TruthRow& row : rows)
    out += csv_exact(name) + "," + (row.layer ? std::to_string(*row.layer) : "") + "," +
           csv_exact(row.template_name) + "," + csv_exact(row.measurement) + "," + cm(row.value) +
           "," + cm(row.published) + "," + cm(row.tol_minus) + "," + cm(row.tol_plus) + "\n";
  return out;
} catch (const ReadError& error) {
  throw HttpProblem(422, "bad_ground_truth", error.what());
}

}  // namespace regarment
