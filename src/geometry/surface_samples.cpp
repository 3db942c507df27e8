#include "geometry/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace regarment {
namespace {

constexpr int kMostPieces = 64;  // per triangle edge: a 20 cm edge at 3 mm spacing

Vec3 colour_of(const Mesh& mesh, std::uint32_t vertex) {
  const Colour& c = mesh.colours[vertex];
  return Vec3(c[0], c[1], c[2]) / 255.0;
}

void add_triangle(const Mesh& mesh, const Triangle& t, double spacing, SurfaceSamples& out) {
  const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  const double area = 0.5 * (b - a).cross(c - a).norm();
  if (!(area > 0)) return;
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, kMostPieces);
  // The centroids of the n^2 congruent pieces of the triangle.
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * (n - i) - 1; ++j) {
      const double third = (j % 2 == 0) ? 1.0 / 3 : 2.0 / 3;
      const Vec3 w(0, (j / 2 + third) / n, (i + third) / n);
      const Vec3 weights(1 - w[1] - w[2], w[1], w[2]);
      Eigen::Index nearest = 0;
      weights.maxCoeff(&nearest);
      out.positions.push_back(weights[0] * a + weights[1] * b + weights[2] * c);
      const Vec3 normal = weights[0] * mesh.normals[t[0]] + weights[1] * mesh.normals[t[1]] +
                          weights[2] * mesh.normals[t[2]];
      out.normals.push_back(normal.norm() > 1e-12 ? Vec3(normal.normalized()) : Vec3::Zero());
      if (!mesh.colours.empty())
        out.colours.push_back(weights[0] * colour_of(mesh, t[0]) +
                              weights[1] * colour_of(mesh, t[1]) +
                              weights[2] * colour_of(mesh, t[2]));
      out.areas.push_back(area / (n * n));
      out.vertex.push_back(t[static_cast<std::size_t>(nearest)]);
    }
  }
}

}  // namespace

SurfaceSamples sample_surface(const Mesh& mesh, double spacing,
                              const std::vector<std::uint8_t>& skip) {
  if (mesh.normals.size() != mesh.positions.size())
    throw InvalidInput("sample_surface: the mesh has no normals");
  const auto skipped = [&](std::uint32_t v) { return !skip.empty() && skip[v] != 0; };
  SurfaceSamples out;
  out.spacing = spacing;
  if (mesh.is_cloud()) {
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      if (skipped(v)) continue;
      out.positions.push_back(mesh.positions[v]);
      out.normals.push_back(mesh.normals[v]);
      if (!mesh.colours.empty()) out.colours.push_back(colour_of(mesh, v));
      out.areas.push_back(spacing * spacing);
      out.vertex.push_back(v);
    }
    return out;
  }
  for (const Triangle& t : mesh.triangles)
    if (!skipped(t[0]) && !skipped(t[1]) && !skipped(t[2])) add_triangle(mesh, t, spacing, out);
  double area = 0;
  for (double a : out.areas) area += a;
  if (!out.areas.empty()) out.spacing = std::sqrt(area / static_cast<double>(out.areas.size()));
  return out;
}

}  // namespace regarment
