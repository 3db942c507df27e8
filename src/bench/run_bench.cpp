#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/closest_point_rivals.h"
#include "bench/measures.h"
#include "report/version.h"
#include "scan/read_sandboxed.h"

namespace regarment {

std::optional<double> BenchRow::ratio() const {
  if (!other_value || !(value > 0)) return std::nullopt;
  return *other_value / value;
}

std::optional<bool> BenchRow::reached() const {
  const std::optional<double> judged = by_ratio ? ratio() : value;
  if (!judged || (!at_most && !at_least)) return std::nullopt;
  return (!at_most || *judged <= *at_most) && (!at_least || *judged >= *at_least);
}

double growth_exponent(const std::vector<GrowthCurve::Point>& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const GrowthCurve::Point& p : points) {
    if (!(p.size > 0 && p.seconds > 0)) continue;
    const double u = std::log(p.size), v = std::log(p.seconds);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  const double spread = n * xx - x * x;
  return n >= 2 && spread > 1e-12 ? (n * xy - x * y) / spread : 0;
}

std::vector<double> best_in_turn(const std::vector<std::function<void()>>& actions, int rounds) {
  std::vector<double> best(actions.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const double start = thread_seconds();
      actions[i]();
      best[i] = std::min(best[i], thread_seconds() - start);
    }
  }
  return best;
}

Bench run_bench(const BenchOptions& options, const Progress& progress) {
  Bench bench;
  bench.version = version();
  bench.scan = options.scan.file.filename().string();
  measure_fits(options, progress, bench);
  const Mesh mesh = read_mesh_sandboxed(options.scan.file, {}, progress).mesh;
  progress.report("parts", 0.0);
  measure_reading(mesh, bench);
  progress.report("parts", 0.2);
  measure_silhouettes(mesh, bench);
  progress.report("parts", 0.4);
  measure_closest_points(mesh, bench);
  progress.report("parts", 0.7);
  measure_solver(bench);
  progress.report("parts", 1.0);
  return bench;
}

}  // namespace regarment
