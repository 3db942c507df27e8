#include "batch/measurements_table.h"

#include <array>

#include "report/csv_table.h"
#include "report/files.h"

namespace regarment {
namespace {

struct Column {
  const char* name;
  bool is_text = false;  // no number, which may begin with a minus
};

constexpr std::array kColumns = {Column{"layer"},      Column{"template", true},
                                 Column{"code", true}, Column{"measurement", true},
                                 Column{"value_cm"},   Column{"low_cm"},
                                 Column{"high_cm"},    Column{"worn_cm"},
                                 Column{"observable"}};
constexpr std::size_t kMostBytes = 1U << 20U;

void add_rows(const std::string& scan, const CsvTable& table, std::string& out) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    out += csv_text(scan);
    for (const Column& column : kColumns) {
      const std::string_view cell = table.cell(i, column.name);
      out.append(",").append(column.is_text ? csv_text(cell) : std::string(cell));
    }
    out += "\n";
  }
}

}  // namespace

std::string measurements_table(const BatchFolder& folder, const Manifest& manifest,
                               const BatchState& state) {
  std::string out = "scan";
  for (const Column& column : kColumns) out.append(",").append(column.name);
  out += "\n";
  for (std::size_t i = 0; i < manifest.scans.size(); ++i) {
    if (state.scans[i]->failure) continue;
    const std::string& name = manifest.scans[i].name;
    const std::filesystem::path file = folder.fit(name) / "measurements.csv";
    add_rows(name, CsvTable::parse(read_file(file, kMostBytes), file.string()), out);
  }
  return out;
}

}  // namespace regarment
