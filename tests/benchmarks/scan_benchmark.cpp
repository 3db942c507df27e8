// Prints how long each stage of make_scan takes on scans named on the command line.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <span>
#include <vector>

#include "base/error.h"
#include "geometry/mesh_io.h"
#include "geometry/point_tree.h"
#include "scan/body_sample.h"
#include "scan/find_up.h"
#include "scan/local_surface.h"
#include "scan/make_scan.h"
#include "scan/mesh_edges.h"
#include "scan/mirror_plane.h"
#include "scan/visible_side.h"
#include "scan/weld.h"

namespace {

using namespace regarment;
using Clock = std::chrono::steady_clock;

// The best of several runs, in milliseconds: what the code takes when nothing else runs.
template <class Action>
void report(const char* what, Action&& action) {
  double best = 1e9;
  for (int run = 0; run < 7; ++run) {
    const auto start = Clock::now();
    action();
    best = std::min(best, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  std::printf("  %-28s %7.1f ms\n", what, best);
}

void measure(const char* file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> content{std::istreambuf_iterator<char>(in), {}};
  const auto bytes = std::as_bytes(std::span(content));
  const Mesh mesh = parse_mesh(bytes, recognise_format(bytes, file), file);
  std::printf("%s: %zu vertices, %zu triangles\n", file, mesh.positions.size(),
              mesh.triangles.size());
  report("make_scan", [&] { make_scan(mesh); });

  const Welded welded = weld(mesh.positions);
  const std::vector<Triangle> triangles = weld_triangles(mesh.triangles, welded);
  report("weld", [&] { weld_triangles(mesh.triangles, weld(mesh.positions)); });
  const BodySample sample = sample_body(welded.positions, triangles);
  report("sample_body", [&] { sample_body(welded.positions, triangles); });
  report("find_up", [&] { find_up(sample); });
  const Scan scan = make_scan(mesh);
  std::vector<Vec3> upright = sample.points;
  for (Vec3& p : upright) p = scan.file_from_body.inverse() * p / scan.facts.height;
  report("find_mirror_plane", [&] { find_mirror_plane(upright); });
  if (mesh.is_cloud()) {
    const std::vector<Vec3>& points = scan.mesh.positions;
    report("PointTree, file order", [&] { PointTree tree(points); });
    const PointTree tree(points);
    report("local_surface, file order", [&] { local_surface(points, tree); });
    report("visible_side",
           [&] { visible_side(points, scan.mesh.normals, points, 2.5 * scan.facts.spacing); });
  } else {
    report("find_edges, sheets, holes", [&] {
      const MeshEdges edges = find_edges(triangles, welded.positions.size());
      find_sheets(triangles.size(), edges);
      count_holes(edges, welded.positions.size());
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::printf("usage: scan_benchmark SCAN...\n");
    return 2;
  }
  try {
    for (int i = 1; i < argc; ++i) measure(argv[i]);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_status();
  }
}
