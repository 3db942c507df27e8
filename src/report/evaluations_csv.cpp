#include "report/evaluations_csv.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "report/csv_table.h"
#include "report/text.h"

namespace regarment {
namespace {

constexpr double kMost = 1e9;  // beyond it there is nothing to see, only overflow
constexpr int kErrorDigits = 6;
// Its root is taken of what is left beside 1, which may be as little as 1e-7.
constexpr int kStretchDecimals = 9;

std::string cell(double value) {
  return std::abs(value) <= kMost ? significant_text(value, kErrorDigits) : "";
}

std::string header(const FitTrace& trace) {
  std::string line = "run,evaluation";
  for (const std::string& name : trace.names) line += "," + name + "_cm";
  return line + ",distance_m,stretch,silhouette,error,best,temperature,drape_steps,came_to_rest\n";
}

std::string row(const FitEvaluation& e) {
  std::string line;
  for (const double length : e.dimensions) line += "," + fixed_text(length * 100.0, 3);
  line += "," + cell(e.terms.distance);
  line += "," +
          (std::abs(e.terms.stretch) <= kMost ? fixed_text(e.terms.stretch, kStretchDecimals) : "");
  line += "," + cell(e.terms.silhouette) + "," + cell(e.error) + "," + cell(e.best);
  line += "," + cell(e.temperature) + "," + std::to_string(e.drape_steps);
  return line + (e.came_to_rest ? ",true\n" : ",false\n");
}

std::vector<std::string> columns_needed(const ResultSearch& search) {
  std::vector<std::string> out = {"run",     "evaluation", "distance_m",
                                  "stretch", "silhouette", "error"};
  for (const SearchedDimension& dimension : search.dimensions) {
    out.push_back(dimension.name + "_cm");
  }
  return out;
}

class Reader {
 public:
  Reader(const CsvTable& table, const ResultSearch& search) : table_(table), search_(search) {
    for (const std::string& column : columns_needed(search)) {
      if (!table.has(column)) {
        throw ReadError(table.name() + ": has no column '" + column + "'" + kAdvice);
      }
    }
  }

  std::vector<RunEvaluations> read() {
    std::vector<RunEvaluations> out;
    for (std::size_t r = 0; r < search_.runs.size(); ++r) {
      out.push_back(read_run(r + 1, search_.runs[r]));
    }
    if (row_ != table_.size()) {
      throw ReadError(table_.name() + ": has more evaluations than result.json tells of" + kAdvice);
    }
    return out;
  }

 private:
  static constexpr const char* kAdvice = "; run 'regarment fit' again";

  RunEvaluations read_run(std::size_t number, const ResultRun& run) {
    RunEvaluations out;
    out.dimensions_cm.resize(search_.dimensions.size());
    for (std::size_t e = 1; e <= run.evaluations; ++e, ++row_) {
      if (row_ == table_.size()) {
        throw ReadError(table_.name() + ": ends at run " + std::to_string(number) +
                        ", before its evaluation " + std::to_string(e) + kAdvice);
      }
      expect("run", number);
      expect("evaluation", e);
      read_row(out);
    }
    check_best(number, run, out.error);
    return out;
  }

  void expect(const char* column, std::size_t value) const {
    if (table_.cell(row_, column) == std::to_string(value)) return;
    throw ReadError(table_.where(row_, column) + ": must be " + std::to_string(value) + kAdvice);
  }

  std::optional<double> maybe(const std::string& column) const {
    const std::optional<double> value = table_.number(row_, column);
    if (value && std::abs(*value) > kMost) {
      throw ReadError(table_.where(row_, column) + ": is too large" + kAdvice);
    }
    return value;
  }

  double number(const std::string& column) const {
    return maybe(column).value_or(std::numeric_limits<double>::quiet_NaN());
  }

  void read_row(RunEvaluations& out) const {
    for (std::size_t d = 0; d < search_.dimensions.size(); ++d) {
      const std::string column = search_.dimensions[d].name + "_cm";
      const std::optional<double> length = maybe(column);
      if (!length) throw ReadError(table_.where(row_, column) + ": is empty" + kAdvice);
      out.dimensions_cm[d].push_back(*length);
    }
    out.terms.push_back({number("distance_m"), number("stretch"), number("silhouette")});
    out.error.push_back(number("error"));
  }

  void check_best(std::size_t number, const ResultRun& run,
                  const std::vector<double>& error) const {
    const double best = error[run.best - 1];
    bool sound = std::isfinite(best);
    for (const double other : error) sound = sound && !(other < best);
    if (sound) return;
    throw ReadError(table_.name() + ": run " + std::to_string(number) +
                    " does not have its smallest error at evaluation " + std::to_string(run.best) +
                    kAdvice);
  }

  const CsvTable& table_;
  const ResultSearch& search_;
  std::size_t row_ = 0;
};

}  // namespace

std::string evaluations_csv(const FitTrace& trace) {
  std::string out = header(trace);
  for (std::size_t r = 0; r < trace.runs.size(); ++r) {
    const std::vector<FitEvaluation>& evaluations = trace.runs[r].evaluations;
    for (std::size_t e = 0; e < evaluations.size(); ++e) {
      out += std::to_string(r + 1) + "," + std::to_string(e + 1) + row(evaluations[e]);
    }
  }
  return out;
}

std::vector<RunEvaluations> read_evaluations(const std::string& csv, const std::string& name,
                                             const ResultSearch& search) {
  const CsvTable table = CsvTable::parse(csv, name);
  return Reader(table, search).read();
}

}  // namespace regarment
