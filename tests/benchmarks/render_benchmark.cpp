// Milliseconds of processor time for the pictures of a report: four views of 520 x 900 pixels in
// four looks. Run: render_benchmark [SCAN.ply]; without a file a body of 90,000 triangles and a
// cloud of 140,000 points are made.

#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh_io.h"
#include "render/context.h"
#include "render/render_figures.h"
#include "render/shapes.h"

namespace regarment {
namespace {

double processor_milliseconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

template <typename Work>
double best_of(int runs, Work work) {
  double best = 1e300;
  for (int run = 0; run < runs; ++run) {
    const double start = processor_milliseconds();
    work();
    best = std::min(best, processor_milliseconds() - start);
  }
  return best;
}

// The mannequin with so many triangles, or its surface as so many random points.
Mesh large_body(bool cloud) {
  Mesh mesh = test::ellipsoid_mesh({0, 1.12, 0}, {0.19, 0.36, 0.13}, 110);
  test::append(mesh, test::ellipsoid_mesh({0, 1.57, 0.02}, {0.085, 0.13, 0.1}, 60));
  for (const double side : {-1.0, 1.0}) {
    test::append(mesh, test::ellipsoid_mesh({0.1 * side, 0.44, 0}, {0.075, 0.44, 0.08}, 70));
    test::append(mesh, test::ellipsoid_mesh({0.45 * side, 1.2, 0.03}, {0.25, 0.05, 0.05}, 50));
  }
  if (!cloud) return mesh;
  Mesh points = test::sphere_cloud(1.0, 140'000, 1);
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const Triangle& t = mesh.triangles[i % mesh.triangles.size()];
    const Vec3 share = points.positions[i].cwiseAbs() / points.positions[i].lpNorm<1>();
    points.positions[i] = share.x() * mesh.positions[t[0]] + share.y() * mesh.positions[t[1]] +
                          share.z() * mesh.positions[t[2]];
    points.normals[i] = mesh.normals[t[0]];
  }
  return points;
}

void measure(const Mesh& scan, const char* name) {
  std::printf("%s: %zu vertices, %zu triangles\n", name, scan.positions.size(),
              scan.triangles.size());
  std::vector<std::uint8_t> labels;
  for (const Vec3& p : scan.positions) labels.push_back(p.y() > 0.5 && p.y() < 1.0 ? 1 : 0);
  const Mesh draped = test::skirt_mesh(1.0, 0.5, 0.2, 0.26);
  const Mesh placed = test::skirt_mesh(1.0, 0.5, 0.28, 0.34);
  const Scene scene = {scan, labels, {},
                       {},   {},     {{draped.triangles, placed.positions, draped.positions, 1}}};
  const std::vector<Look> looks = {Look::Scan, Look::Segmentation, Look::Placement, Look::Drape};
  FigureOptions options;
  const auto cost = [&](const std::vector<Look>& some, const std::vector<View>& views) {
    options.views = views;
    return best_of(3, [&] { render_figures(scene, some, options); });
  };
  std::vector<Figure> figures;
  options.views = four_sides();
  const double cold = best_of(1, [&] { figures = render_figures(scene, looks, options); });
  std::printf("  16 pictures: %.0f ms the first time, %.0f ms again\n", cold,
              cost(looks, four_sides()));
  for (const View view : four_sides()) {
    std::printf("  view %s: %.0f ms for 4 pictures\n", std::string(view_name(view)).c_str(),
                cost(looks, {view}));
  }
  for (const Look look : looks) {
    std::printf("  look %s alone: %.0f ms for 4 pictures\n", std::string(look_name(look)).c_str(),
                cost({look}, four_sides()));
  }
  for (const auto& [format, label] :
       {std::pair(ImageFormat::Jpeg, "JPEG"), std::pair(ImageFormat::Png, "PNG"),
        std::pair(ImageFormat::WebP, "WebP")}) {
    std::size_t bytes = 0;
    const double time = best_of(1, [&, chosen = format] {
      for (const Figure& f : figures) bytes += encode_image(f.image, chosen).size();
    });
    std::printf("  16 pictures as %s: %.0f ms, %zu KB\n", label, time, bytes / 1000);
  }
}

Mesh read_scan(const char* file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Mesh mesh = parse_mesh(std::as_bytes(std::span(text)), MeshFormat::Ply, file);
  return mesh;
}

}  // namespace
}  // namespace regarment

int main(int argc, char** argv) {
  std::printf("%s\n", regarment::Context::of_this_thread().description().c_str());
  if (argc > 1) {
    regarment::measure(regarment::read_scan(argv[1]), argv[1]);
    return 0;
  }
  regarment::measure(regarment::large_body(false), "mesh");
  regarment::measure(regarment::large_body(true), "cloud");
  return 0;
}
