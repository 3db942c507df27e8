#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/closest_point_rivals.h"
#include "bench/measures.h"
#include "garment/find_template.h"
#include "garment/pattern.h"
#include "render/silhouette.h"

namespace regarment {
namespace {

constexpr int kSize = 256;  // pixels
constexpr std::size_t kGarmentTriangles = 6'000, kScanTriangles = 400'000;
constexpr double kGarmentAim = 5, kScanAim = 100;  // ms

/// A skirt of this many triangles wrapped round the upright axis.
Mesh wrapped_skirt() {
  const GarmentTemplate skirt = find_template("skirt");
  Pattern pattern;
  for (double edge = 0.05; pattern.triangles.size() < kGarmentTriangles; edge *= 0.95)
    pattern = make_pattern(skirt, skirt.typical(), edge);
  double half_width = 0;
  for (const Vec2& p : pattern.flat) half_width = std::max(half_width, std::abs(p.x()));
  Mesh out;
  out.triangles = pattern.triangles;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const double turn = std::numbers::pi / 2 * pattern.flat[v].x() / half_width;
    const double radius = 0.13 + 0.2 * pattern.flat[v].y();
    const double front = pattern.panel_is_front[pattern.panel[v]] ? 1 : -1;
    out.positions.emplace_back(radius * std::sin(turn), 1 - pattern.flat[v].y(),
                               front * radius * std::cos(turn));
  }
  return out;
}

BenchRow row_of(const std::string& name, const Mesh& mesh, const Box& box, double aim) {
  Framing framing;
  framing.width = framing.height = kSize;
  const std::vector<Camera> cameras = frame_views(box, four_sides(), framing);
  SilhouetteRenderer renderer(mesh.triangles, mesh.positions.size(), kSize);
  const double seconds = best_in_turn({[&] { renderer.draw(mesh.positions, cameras); }}, 10)[0];
  return {.group = "Silhouettes",
          .name = "four of " + name + ", " + std::to_string(mesh.triangles.size()) + " triangles",
          .value = 1e3 * seconds,
          .unit = "ms",
          .at_most = aim};
}

}  // namespace

void measure_silhouettes(const Mesh& mesh, Bench& bench) {
  const Box person{{-0.5, 0, -0.2}, {0.5, 1.75, 0.2}};
  bench.rows.push_back(row_of("a skirt", wrapped_skirt(), person, kGarmentAim));
  if (mesh.is_cloud()) return;
  Mesh finer;
  finer.positions = mesh.positions, finer.triangles = mesh.triangles;
  subdivide(finer, kScanTriangles);
  bench.rows.push_back(row_of("the scan", finer, bounding_box(finer.positions), kScanAim));
}

}  // namespace regarment
