#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/median.h"
#include "bench/closest_point_rivals.h"
#include "bench/measures.h"
#include "evaluation/child_pool.h"
#include "geometry/ply_writer.h"
#include "report/files.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kMostJson = std::size_t{64} << 20U;
constexpr double kOneGarment = 1.5, kTwoGarments = 4, kLargeScan = 4;  // s, what is aimed at
constexpr double kMemory = 1024;                                       // MiB
constexpr double kLarge = 9e5;                                         // vertices

struct FitTimes {
  double wall = 0, processor = 0;        // s
  std::map<std::string, double> stages;  // s
  std::optional<double> error_cm;        // mean over the dimensions whose truth is given
};

std::optional<double> mean_error(const Json& result) {
  double sum = 0, n = 0;
  for (const Json& garment : result.at("garments"))
    for (const Json& m : garment.at("measurements"))
      if (m.contains("error_cm") && m.at("observable").get<bool>())
        sum += std::abs(m.at("error_cm").get<double>()), n += 1;
  if (n == 0) return std::nullopt;
  return sum / n;
}

/// Of all processes that have been waited for.
double child_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

FitTimes fit_once(const BenchOptions& options, const fs::path& scan, const std::string& method,
                  const Progress& progress) {
  const fs::path out = options.work / "fit";
  std::vector<std::string> words = {options.program.string(),
                                    "fit",
                                    scan.string(),
                                    "--out",
                                    out.string(),
                                    "--force",
                                    "--quiet",
                                    "--method",
                                    method};
  for (const std::string& garment : options.garments)
    words.insert(words.end(), {"--garment", garment});
  if (scan == options.scan) words.insert(words.end(), options.truth.begin(), options.truth.end());
  ChildEnd end;
  const double before = child_seconds();
  run_children(
      {words}, {}, [&](std::size_t, const ChildEnd& how) { end = how; },
      [&] { progress.report("fits", 0.5); });
  if (end.status != 0) throw Error(end.status, "bench: a fit ended with: " + end.last_line);
  const Json result = Json::parse(read_file(out / "result.json", kMostJson));
  FitTimes times{end.seconds, child_seconds() - before, {}, mean_error(result)};
  double all = 0;
  for (const auto& [stage, seconds] : result.at("timing_s").items()) {
    if (stage == "total") continue;
    times.stages[stage] = seconds, all += seconds.get<double>();
  }
  times.stages["report"] = std::max(0.0, end.seconds - all);
  return times;
}

/// MiB of the largest process that has been waited for.
double largest_child() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void add_stages(const std::vector<FitTimes>& fits, Bench& bench) {
  for (const std::string stage : {"read", "prepare", "place", "measure", "report"}) {
    std::vector<double> all;
    for (const FitTimes& fit : fits)
      if (fit.stages.contains(stage)) all.push_back(fit.stages.at(stage));
    if (all.empty()) continue;
    BenchRow row{.group = "A fit", .name = stage, .value = median(all), .unit = "s"};
    if (stage == "report")
      row.name = "report, and what the program takes to start", row.at_most = 0.5;
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
void measure_growth(const BenchOptions& options, double first, const Progress& progress,
                    Bench& bench) {
  Mesh mesh = read_mesh_sandboxed(options.scan, {}, progress).mesh;
  GrowthCurve curve{"a fit", "vertices", {}, 0};
  curve.points.push_back({static_cast<double>(mesh.positions.size()), first});
  if (mesh.is_cloud()) return;
  mesh.normals.clear();
  const auto steps = static_cast<int>(
      std::ceil(std::log(options.most_vertices / curve.points[0].size) / std::log(3.0)));
  const double factor = std::pow(options.most_vertices / curve.points[0].size, 1.0 / steps);
  for (int step = 1; step <= steps; ++step) {
    grow(mesh, curve.points[0].size * std::pow(factor, step));
    const double seconds = fit_once(options, finer_copy(mesh, options), "joint", progress).wall;
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

}  // namespace

void measure_fits(const BenchOptions& options, const Progress& progress, Bench& bench) {
  std::vector<FitTimes> fits;
  std::vector<double> wall;
  for (int i = 0; i < options.repeats; ++i) {
    progress.report("fits", static_cast<double>(i) / options.repeats);
    fits.push_back(fit_once(options, options.scan, "joint", progress));
    wall.push_back(fits.back().wall);
  }
  BenchRow all{.group = "A fit",
               .name = "from the file to the report, median of " + std::to_string(wall.size()),
               .value = median(wall),
               .unit = "s",
               .at_most = options.garments.size() > 1 ? kTwoGarments : kOneGarment};
  BenchRow error{.group = "A fit", .name = "mean error", .value = 0, .unit = "cm"};
  if (fits[0].error_cm) error.value = *fits[0].error_cm;
  if (options.annealing) {
    const FitTimes other = fit_once(options, options.scan, "annealing", progress);
    all.other = error.other = "annealing";
    all.other_value = other.wall, error.other_value = other.error_cm;
  }
  const double first = all.value;
  std::vector<double> processor;
  processor.reserve(fits.size());
  for (const FitTimes& fit : fits) processor.push_back(fit.processor);
  bench.rows.push_back(std::move(all));
  bench.rows.push_back({.group = "A fit",
                        .name = "processor time of it, all threads",
                        .value = median(processor),
                        .unit = "s"});
  add_stages(fits, bench);
  if (fits[0].error_cm) bench.rows.push_back(std::move(error));
  bench.rows.push_back({.group = "A fit",
                        .name = "most memory, this scan",
                        .value = largest_child(),
                        .unit = "MiB"});
  measure_growth(options, first, progress, bench);
  progress.report("fits", 1.0);
}

}  // namespace regarment
