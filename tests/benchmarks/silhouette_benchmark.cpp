// Milliseconds of processor time for the four silhouettes of 256 x 256 pixels that an evaluation of
// the search draws: of a skirt of about 6,000 triangles, and of a scan of 400,000. Run:
// silhouette_benchmark [SCAN.ply]; the scan's triangles are split until there are enough, without a
// file it is an ellipsoid. Prints the median and the best of many runs.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "garment/find_template.h"
#include "garment/pattern.h"
#include "geometry/mesh_io.h"
#include "render/context.h"
#include "render/shapes.h"
#include "render/silhouette.h"

namespace regarment {
namespace {

constexpr int kSize = 256;
constexpr std::size_t kGarmentTriangles = 6'000, kScanTriangles = 400'000;

double processor_milliseconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

/// A skirt wrapped round the upright axis, with folds towards its hem.
Mesh worn_skirt() {
  const GarmentTemplate skirt = find_template("skirt");
  Pattern pattern;
  for (double edge = 0.05; pattern.triangles.size() < kGarmentTriangles; edge *= 0.95)
    pattern = make_pattern(skirt, skirt.typical(), edge);
  double half_width = 0, length = 0;
  for (const Vec2& p : pattern.flat) {
    half_width = std::max(half_width, std::abs(p.x()));
    length = std::max(length, p.y());
  }
  Mesh mesh;
  mesh.triangles = pattern.triangles;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const double s = pattern.flat[v].x() / half_width, t = pattern.flat[v].y() / length;
    const double turn = std::numbers::pi / 2 * s;
    const double radius = (0.13 + 0.12 * t) * (1 + 0.08 * t * std::cos(14 * turn));
    const double front = pattern.panel_is_front[pattern.panel[v]] ? 1 : -1;
    mesh.positions.emplace_back(radius * std::sin(turn), 1.03 - length * t,
                                front * radius * std::cos(turn));
  }
  return mesh;
}

/// Each triangle becomes four.
Mesh split(const Mesh& mesh) {
  Mesh out;
  out.positions = mesh.positions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(out.positions.size()));
    if (is_new) out.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    out.triangles.insert(out.triangles.end(),
                         {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return out;
}

Mesh scan_from(const char* file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Mesh mesh = parse_mesh(std::as_bytes(std::span(bytes)), MeshFormat::Ply, file);
  if (mesh.is_cloud()) throw UsageError(std::string(file) + ": a cloud has no silhouette");
  while (4 * mesh.triangles.size() <= kScanTriangles) mesh = split(mesh);
  // The last ones by a vertex in the middle of a triangle, which makes three of it.
  for (std::size_t t = 0; mesh.triangles.size() + 2 <= kScanTriangles; ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3);
    mesh.triangles[t] = {a, b, middle};
    mesh.triangles.push_back({b, c, middle});
    mesh.triangles.push_back({c, a, middle});
  }
  return mesh;
}

void measure(const char* name, const Mesh& mesh, const Box& box, int runs) {
  Framing framing;
  framing.width = framing.height = kSize;
  const std::vector<Camera> cameras = frame_views(box, four_sides(), framing);
  SilhouetteRenderer renderer(mesh.triangles, mesh.positions.size(), kSize);
  std::size_t area = 0;
  for (const Silhouette& side : renderer.draw(mesh.positions, cameras)) area += side.area();
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) {
    const double start = processor_milliseconds();
    renderer.draw(mesh.positions, cameras);
    times.push_back(processor_milliseconds() - start);
  }
  std::sort(times.begin(), times.end());
  std::printf("%s: %zu triangles, %zu pixels covered: median %.2f ms, best %.2f ms of %d\n", name,
              mesh.triangles.size(), area, times[times.size() / 2], times.front(), runs);
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) {
  using namespace regarment;
  try {
    std::printf("%s\n", Context::of_this_thread().description().c_str());
    const Box person{{-0.5, 0, -0.2}, {0.5, 1.75, 0.2}};  // what a fit frames
    measure("skirt", worn_skirt(), person, 300);
    const Mesh scan =
        argc > 1 ? scan_from(argv[1]) : test::ellipsoid_mesh({0, 0.9, 0}, {0.4, 0.85, 0.2}, 317);
    measure("scan", scan, bounding_box(scan.positions), 15);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_status();
  }
  return 0;
}
