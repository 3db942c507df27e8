#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"

namespace regarment {

/// One figure, and where there is one, what another program or method takes for the same.
struct BenchRow {
  std::string group, name;
  double value = 0;
  std::string unit;
  std::string other = {};                  // who `other_value` is of
  std::optional<double> other_value = {};  // in `unit`
  std::optional<double> at_most = {},
                        at_least = {};  // of the value; or of the ratio, see `by_ratio`
  bool by_ratio = false;

  /// The other's value over ours: how many times faster we are, where the unit is a time.
  std::optional<double> ratio() const;
  /// Whether what is aimed at is reached; nothing when nothing is.
  std::optional<bool> reached() const;
};

/// How a time grows with a size.
struct GrowthCurve {
  std::string name, size_unit;
  struct Point {
    double size = 0, seconds = 0;
  };
  std::vector<Point> points;  // by size
  double exponent = 0;        // p of seconds ~ size^p, see growth_exponent()
};

struct Bench {
  std::string version, scan;
  std::vector<BenchRow> rows;
  std::vector<GrowthCurve> curves;
};

/// What is fitted.
struct BenchScan {
  std::filesystem::path file;           // a mesh or cloud
  std::vector<std::string> garments;    // outermost first
  std::vector<std::string> truth = {};  // further words of each fit, such as --ground-truth FILE
};

struct BenchOptions {
  std::filesystem::path program;    // absolute: what fits the scan
  std::filesystem::path work;       // an empty folder for what is made meanwhile
  BenchScan scan;                   // of all figures but one
  std::optional<BenchScan> layers;  // of the time of a fit with several garments
  int repeats = 5;                  // of each fit
  bool annealing = false;           // fit by that method once as well, which takes minutes
  double most_vertices = 1e6;       // of the largest scan that growth is shown with
};

/// Least squares of log seconds over log size; 0 for fewer than two sizes.
double growth_exponent(const std::vector<GrowthCurve::Point>& points);

/// Measures everything in one run: fits as processes of their own, then the parts in this one, each
/// beside its yardstick in turn. Times of parts are processor time of one thread, the best of some
/// rounds; times of fits are wall time, the median. Throws what a fit that fails says.
Bench run_bench(const BenchOptions& options, const Progress& progress);

/// The table for a terminal.
std::string bench_text(const Bench& bench);
/// Everything as JSON: {"schema": "regarment.bench/1", "version", "scan", "rows": [{"group",
/// "name", "value", "unit", "other"?, "other_value"?, "ratio"?, "reached"?}], "curves": [{"name",
/// "size_unit", "exponent", "points": [{"size", "seconds"}]}]}.
std::string bench_json(const Bench& bench);
/// The table and the curves as a page that requests nothing.
std::string bench_page(const Bench& bench);

}  // namespace regarment
