#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/error.h"
#include "base/median.h"
#include "bench/closest_point_rivals.h"
#include "bench/measures.h"
#include "bench/timed_fits.h"
#include "geometry/ply_writer.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// What is aimed at.
constexpr double kOneGarment = 1.5, kTwoGarments = 4, kRefit = 1, kLargeScan = 4;  // s
constexpr double kReport = 0.5;                                                    // s
constexpr double kMemory = 1024;                                                   // MiB
constexpr double kLarge = 9e5;                                                     // vertices
constexpr std::size_t kStarts = 20;

void add_stages(const std::vector<FitTimes>& fits, Bench& bench) {
  for (const std::string stage : {"read", "prepare", "place", "measure", "report"}) {
    std::vector<double> all;
    for (const FitTimes& fit : fits)
      if (fit.stages.contains(stage)) all.push_back(fit.stages.at(stage));
    if (all.empty()) continue;
    BenchRow row{.group = "A fit", .name = stage, .value = median(all), .unit = "s"};
    if (stage == "report")
      row.name = "report, and what the program takes to start", row.at_most = kReport;
    bench.rows.push_back(row);
  }
}

fs::path finer_copy(const Mesh& mesh, const BenchOptions& options) {
  fs::path file = options.work / "finer.ply";
  std::ofstream out(file, std::ios::binary);
  PlyWriter(mesh.positions.size()).positions(mesh.positions).triangles(mesh.triangles).write(out);
  out.close();
  if (!out) throw TemporaryError(file.string() + ": cannot be written; is there room?");
  return file;
}

/// A surface has about twice as many triangles as vertices.
void grow(Mesh& mesh, double vertices) {
  while (static_cast<double>(mesh.positions.size()) < vertices) {
    const double missing = vertices - static_cast<double>(mesh.positions.size());
    const auto more = std::max<std::size_t>(1000, static_cast<std::size_t>(2 * missing));
    subdivide(mesh, mesh.triangles.size() + more);
  }
}

/// Fits of the same person with more and more vertices.
void measure_growth(const BenchOptions& options, const FitTimer& timer, double first,
                    Bench& bench) {
  Mesh mesh = read_mesh_sandboxed(options.scan.file).mesh;
  GrowthCurve curve{"a fit", "vertices", {}, 0};
  curve.points.push_back({static_cast<double>(mesh.positions.size()), first});
  if (mesh.is_cloud()) return;
  mesh.normals.clear();
  const auto steps = static_cast<int>(
      std::ceil(std::log(options.most_vertices / curve.points[0].size) / std::log(3.0)));
  const double factor = std::pow(options.most_vertices / curve.points[0].size, 1.0 / steps);
  for (int step = 1; step <= steps; ++step) {
    grow(mesh, curve.points[0].size * std::pow(factor, step));
    const BenchScan finer{finer_copy(mesh, options), options.scan.garments};
    const double seconds = timer.fit(finer, "joint").wall;
    curve.points.push_back({static_cast<double>(mesh.positions.size()), seconds});
  }
  if (steps > 0) {
    const GrowthCurve::Point& last = curve.points.back();
    BenchRow row{.group = "A fit",
                 .name = "of " + std::to_string(static_cast<long>(last.size)) + " vertices",
                 .value = last.seconds,
                 .unit = "s"};
    if (last.size > kLarge) row.at_most = kLargeScan;
    bench.rows.push_back(row);
    bench.rows.push_back({.group = "A fit",
                          .name = "most memory, any scan",
                          .value = largest_child(),
                          .unit = "MiB",
                          .at_most = kMemory});
  }
  curve.exponent = growth_exponent(curve.points);
  bench.curves.push_back(std::move(curve));
}

// "from the file to the report", "two layers, to the report"
std::string name_of(const BenchScan& scan) {
  const std::size_t n = scan.garments.size();
  const std::string words = "to the report";
  if (n < 2) return "from the file " + words;
  return (n == 2 ? "two" : std::to_string(n)) + " layers, " + words;
}

BenchRow median_row(const std::string& name, const std::vector<double>& seconds) {
  return {.group = "A fit",
          .name = name + ", median of " + std::to_string(seconds.size()),
          .value = median(seconds),
          .unit = "s"};
}

BenchRow fit_row(const BenchScan& scan, const std::vector<double>& seconds) {
  BenchRow row = median_row(name_of(scan), seconds);
  if (scan.garments.size() <= 2)
    row.at_most = scan.garments.size() == 2 ? kTwoGarments : kOneGarment;
  return row;
}

void measure_layers(const BenchOptions& options, const FitTimer& timer, Bench& bench) {
  if (!options.layers) return;
  std::vector<double> wall(static_cast<std::size_t>(options.repeats));
  for (double& seconds : wall) seconds = timer.fit(*options.layers, "joint").wall;
  bench.rows.push_back(fit_row(*options.layers, wall));
}

void measure_start(const FitTimer& timer, Bench& bench) {
  std::vector<double> starts(kStarts);
  for (double& seconds : starts) seconds = timer.start();
  BenchRow row = median_row("start of the program: regarment --version", starts);
  row.value *= 1e3, row.unit = "ms";
  bench.rows.push_back(std::move(row));
}

}  // namespace

void measure_fits(const BenchOptions& options, const Progress& progress, Bench& bench) {
  double share = 0;
  const FitTimer timer(options, [&] { progress.report("fits", share); });
  std::vector<FitTimes> fits;
  std::vector<double> wall, again, processor;
  for (int i = 0; i < options.repeats; ++i) {
    share = 0.5 * i / options.repeats;
    fits.push_back(timer.fit(options.scan, "joint"));
    wall.push_back(fits.back().wall), processor.push_back(fits.back().processor);
    again.push_back(timer.refit());
  }
  BenchRow all = fit_row(options.scan, wall),
           refit = median_row("fitted again from its state, to the report", again);
  if (options.scan.garments.size() == 1) refit.at_most = kRefit;
  BenchRow error{.group = "A fit", .name = "mean error", .value = 0, .unit = "cm"};
  if (fits[0].error_cm) error.value = *fits[0].error_cm;
  if (options.annealing) {
    const FitTimes other = timer.fit(options.scan, "annealing");
    all.other = error.other = "annealing";
    all.other_value = other.wall, error.other_value = other.error_cm;
  }
  const double first = all.value;
  bench.rows.push_back(std::move(all));
  bench.rows.push_back({.group = "A fit",
                        .name = "processor time of it, all threads",
                        .value = median(processor),
                        .unit = "s"});
  add_stages(fits, bench);
  measure_start(timer, bench);
  bench.rows.push_back(std::move(refit));
  if (fits[0].error_cm) bench.rows.push_back(std::move(error));
  bench.rows.push_back({.group = "A fit",
                        .name = "most memory, this scan",
                        .value = largest_child(),
                        .unit = "MiB"});
  share = 0.5;
  measure_layers(options, timer, bench);
  share = 0.7;
  measure_growth(options, timer, first, bench);
  progress.report("fits", 1.0);
}

}  // namespace regarment
