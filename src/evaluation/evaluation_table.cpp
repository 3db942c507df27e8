#include "evaluation/evaluation_table.h"

#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/one_line.h"
#include "evaluation/find_scans.h"
#include "garment/find_template.h"
#include "report/ground_truth.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLayers = 8;
constexpr double kLongestWorn = 1000;  // cm
constexpr std::size_t kMostScans = 50'000;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> out;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, at);) {
    const auto begin = word.find_first_not_of(" \t"), end = word.find_last_not_of(" \t");
    if (begin != std::string::npos) out.push_back(word.substr(begin, end - begin + 1));
  }
  return out;
}

// "scans/skirt-1" of "scans/skirt-1.mesh.ply" and of "scans/skirt-1.cloud.ply", which show one
// garment.
std::string stem_of(const fs::path& scan) {
  const std::string name = scan.filename().string();
  return (scan.parent_path() / name.substr(0, name.find('.', 1))).generic_string();
}

// The rows with a truth, and of scans that have none those that say what is worn; as they stand in
// the table.
std::vector<TruthRow> campaign_rows(const CsvTable& table) {
  std::vector<TruthRow> rows;
  if (table.has("measurement")) rows = truth_rows(table);
  std::set<std::string> known;
  for (const TruthRow& row : rows) known.insert(row.scan);
  for (TruthRow& row : garment_rows(table)) {
    if (!known.contains(row.scan)) rows.push_back(std::move(row));
  }
  std::sort(rows.begin(), rows.end(),
            [](const TruthRow& a, const TruthRow& b) { return a.line < b.line; });
  return rows;
}

// A table with what its rows mean.
class Reader {
 public:
  Reader(const CsvTable& table, std::vector<TruthRow> rows)
      : table_(table), rows_(std::move(rows)) {
    for (std::size_t i = 0; i < table.size(); ++i) {
      row_of_line_[table.line(i)] = i;
      rows_named_[std::string(table.cell(i, "scan"))].push_back(i);
    }
  }

  const std::vector<TruthRow>& rows() const { return rows_; }

  // The scans as they are written, each once.
  std::vector<std::string> written() const {
    std::vector<std::string> out;
    std::set<std::string> seen;
    for (const TruthRow& row : rows_) {
      if (seen.insert(row.scan).second) out.push_back(row.scan);
    }
    if (out.size() > kMostScans) {
      throw ReadError(table_.name() + ": names more than 50000 scans; cut it into several tables");
    }
    return out;
  }

  EvaluationCase make_case(const std::vector<TruthRow>& rows) {
    EvaluationCase out;
    for (const TruthRow& row : rows) {
      if (row.measurement.empty()) {
        template_named(row);
        continue;
      }
      TrueDimension dimension = dimension_of(row);
      for (const TrueDimension& other : out.dimensions) {
        if (other.layer == dimension.layer && other.measurement == dimension.measurement) {
          fail(row, "measurement",
               "'" + dimension.measurement + "' of this garment is given twice");
        }
      }
      out.dimensions.push_back(std::move(dimension));
      out.truth_rows += row_text(row) + "\n";
    }
    out.garments = garments_of(rows);
    std::istringstream words(said(rows, "options"));
    for (std::string word; words >> word;) out.options.push_back(word);
    out.garment = said(rows, "garment");
    if (out.garment.empty()) out.garment = stem_of(rows.front().scan);
    out.kind = said(rows, "kind");
    out.damage = split(said(rows, "damage"), ';');
    std::erase(out.damage, "none");
    out.frame = {said(rows, "units"), said(rows, "up"), split(said(rows, "front"), ';')};
    return out;
  }

  // What the rows of a scan say in a column that speaks of the whole scan.
  std::string said(const std::vector<TruthRow>& rows, const std::string& column) const {
    std::string out;
    for (const TruthRow& row : rows) {
      const std::string cell(table_.cell(row_of_line_.at(row.line), column));
      if (cell.empty() || cell == out) continue;
      if (!out.empty())
        fail(row, column,
             "'" + one_line(cell, 60) + "' is not what an earlier row says of this scan");
      out = cell;
    }
    return out;
  }

  [[noreturn]] void fail(const TruthRow& row, std::string_view column,
                         const std::string& what) const {
    throw ReadError(table_.where(row_of_line_.at(row.line), column) + ": " + what);
  }

 private:
  TrueDimension dimension_of(const TruthRow& row) {
    const std::size_t line = row_of_line_.at(row.line);
    TrueDimension out;
    out.line = row.line;
    out.layer = row.layer.value_or(1);
    out.template_name = row.template_name;
    const Dimension known = dimension_named(row);
    out.measurement = known.name;
    out.code = known.code;
    out.circumference = known.circumference;
    out.truth_cm = 100 * row.value;
    if (row.published) out.published_cm = 100 * *row.published;
    if (row.tol_minus) out.tol_minus_cm = 100 * *row.tol_minus;
    if (row.tol_plus) out.tol_plus_cm = 100 * *row.tol_plus;
    out.worn_cm = table_.number(line, "worn_cm");
    if (out.worn_cm && !(*out.worn_cm > 0 && *out.worn_cm <= kLongestWorn)) {
      fail(row, "worn_cm", "is outside 0 to 1000 cm; give centimetres");
    }
    out.observable = yes_or_no(table_, line, "observable");
    return out;
  }

  Dimension dimension_named(const TruthRow& row) {
    if (row.template_name.empty()) fail(row, "template", "is empty; name the garment's template");
    for (const Dimension& dimension : template_named(row).dimensions()) {
      if (dimension.name == row.measurement || dimension.code == row.measurement) return dimension;
    }
    fail(row, "measurement",
         "the template " + row.template_name + " has no measurement '" +
             one_line(row.measurement, 60) + "'; see 'regarment templates'");
  }

  std::string row_text(const TruthRow& row) const {
    std::string out;
    for (const char* column :
         {"layer", "template", "measurement", "value_cm", "ground_truth_cm", "published_cm",
          "published_estimate_cm", "tol_minus_cm", "tol_plus_cm"}) {
      out.append(table_.cell(row_of_line_.at(row.line), column)).append("|");
    }
    return out;
  }

  const GarmentTemplate& template_named(const TruthRow& row) {
    const auto known = templates_.find(row.template_name);
    if (known != templates_.end()) return known->second;
    try {
      return templates_.emplace(row.template_name, find_template(row.template_name)).first->second;
    } catch (const UsageError& error) {
      fail(row, "template", error.what());
    }
  }

  // Every layer down to the innermost one must be named, also where nothing of it is known.
  std::vector<std::string> garments_of(const std::vector<TruthRow>& rows) const {
    std::vector<std::string> out;
    const auto add = [&](const TruthRow& row, int layer, const std::string& name) {
      if (layer > kMostLayers) fail(row, "layer", "more than 8 layers");
      if (out.size() < static_cast<std::size_t>(layer)) out.resize(static_cast<std::size_t>(layer));
      std::string& there = out[static_cast<std::size_t>(layer) - 1];
      if (!there.empty() && there != name) {
        fail(row, "template",
             "layer " + std::to_string(layer) + " is " + there +
                 " in an earlier row; give each garment a layer of its own");
      }
      there = name;
    };
    for (const TruthRow& row : rows) add(row, row.layer.value_or(1), row.template_name);
    for (const std::size_t i : rows_named_.at(rows.front().scan)) {
      const std::optional<double> layer = table_.number(i, "layer");
      if (table_.cell(i, "template").empty()) continue;
      add(rows.front(), layer ? static_cast<int>(*layer) : 1,
          std::string(table_.cell(i, "template")));
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (out[i].empty()) {
        fail(rows.front(), "layer",
             "layer " + std::to_string(i + 1) +
                 " of this scan is nowhere named; give it a row (its value may be empty)");
      }
    }
    return out;
  }

  const CsvTable& table_;
  std::vector<TruthRow> rows_;
  std::map<std::size_t, std::size_t> row_of_line_;
  std::map<std::string, std::vector<std::size_t>> rows_named_;  // of the table, by their scan
  std::map<std::string, GarmentTemplate> templates_;
};

std::string plain_name(const std::string& text) {
  std::string out;
  for (const char c : text.substr(0, 120)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || (c == '.' && !out.empty());
    out += plain ? c : '_';
  }
  return out.empty() ? "scan" : out;
}

// A name no other case has.
void name_case(const std::string& wish, std::set<std::string>& taken, EvaluationCase& out) {
  out.name = plain_name(wish);
  for (int i = 2; !taken.insert(out.name).second; ++i) {
    out.name = plain_name(wish) + "-" + std::to_string(i);
  }
}

bool wanted(const EvaluationCase& one, const std::string& only) {
  return only.empty() || ::fnmatch(only.c_str(), one.name.c_str(), 0) == 0 ||
         ::fnmatch(only.c_str(), one.scan.filename().c_str(), 0) == 0;
}

// "skirt-1" of "skirt-1.mesh.ply".
bool is_stem_of(const std::string& stem, const std::string& name) {
  return name.starts_with(stem + ".");
}

std::vector<TruthRow> rows_of_estimate(const Reader& reader, const fs::path& table_folder,
                                       const std::string& estimated) {
  std::vector<TruthRow> out = rows_of_scan(reader.rows(), table_folder, estimated);
  if (!out.empty()) return out;
  const std::string stem = fs::path(estimated).filename().string();
  for (const TruthRow& row : reader.rows()) {
    if (!is_stem_of(stem, fs::path(row.scan).filename().string())) continue;
    // Of several files with this stem the first; they show one garment.
    if (out.empty() || out.front().scan == row.scan) out.push_back(row);
  }
  return out;
}

std::vector<EvaluationCase> cases_of(Reader reader, const CsvTable& table,
                                     const fs::path& table_folder,
                                     const std::optional<fs::path>& scans,
                                     const std::string& only) {
  const TruthIndex truth(reader.rows(), table_folder);
  std::vector<EvaluationCase> out;
  std::set<std::string> names;
  std::set<fs::path> files;
  for (const std::string& written : reader.written()) {
    std::vector<fs::path> found = find_scans(written, table_folder, scans);
    if (found.empty()) found = {table_folder / written};
    for (const fs::path& file : found) {
      if (!files.insert(file).second) continue;
      std::vector<TruthRow> rows = truth.rows_of(file);
      if (rows.empty()) continue;
      EvaluationCase one = reader.make_case(rows);
      one.scan = file;
      const std::string labels = reader.said(rows, "labels");
      if (!labels.empty() && found.size() > 1) {
        reader.fail(rows.front(), "labels", "the scan means several files; name each in a row");
      }
      one.labels = find_labels(labels, file, table_folder, scans);
      name_case(file.stem().string(), names, one);
      if (wanted(one, only)) out.push_back(std::move(one));
    }
  }
  if (out.empty()) {
    throw UsageError(table.name() + ": " +
                     (only.empty() ? "names no scan with a value; give it rows"
                                   : "has no scan that matches --only " + one_line(only, 80)));
  }
  return out;
}

}  // namespace

std::optional<bool> yes_or_no(const CsvTable& table, std::size_t row, std::string_view column) {
  const std::string_view cell = table.cell(row, column);
  if (cell.empty()) return std::nullopt;
  if (cell == "true" || cell == "1" || cell == "yes") return true;
  if (cell == "false" || cell == "0" || cell == "no") return false;
  throw ReadError(table.where(row, column) + ": '" + one_line(cell, 40) +
                  "' is neither true nor false");
}

std::vector<EvaluationCase> read_evaluation_table(const CsvTable& table,
                                                  const fs::path& table_folder,
                                                  const std::optional<fs::path>& scans,
                                                  const std::string& only) {
  return cases_of(Reader(table, truth_rows(table)), table, table_folder, scans, only);
}

std::vector<EvaluationCase> read_campaign_table(const CsvTable& table, const fs::path& table_folder,
                                                const std::optional<fs::path>& scans,
                                                const std::string& only) {
  return cases_of(Reader(table, campaign_rows(table)), table, table_folder, scans, only);
}

std::vector<EvaluationCase> cases_of_estimates(const CsvTable& table, const fs::path& table_folder,
                                               const std::vector<std::string>& estimated) {
  Reader reader(table, truth_rows(table));
  std::vector<EvaluationCase> out;
  std::set<std::string> names, known;
  const auto add = [&](const std::string& scan, const std::vector<TruthRow>& rows) {
    EvaluationCase one = reader.make_case(rows);
    one.scan = scan;
    name_case(fs::path(scan).filename().string(), names, one);
    for (const TruthRow& row : rows) known.insert(row.scan);
    out.push_back(std::move(one));
  };
  for (const std::string& scan : estimated) {
    const std::vector<TruthRow> rows = rows_of_estimate(reader, table_folder, scan);
    if (!rows.empty()) add(scan, rows);
  }
  for (const std::string& scan : reader.written()) {
    if (!known.contains(scan)) add(scan, rows_of_scan(reader.rows(), table_folder, scan));
  }
  return out;
}

}  // namespace regarment
