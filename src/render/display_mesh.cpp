#include "render/display_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "render/camera.h"
#include "render/display_normals.h"
#include "render/vertex_clusters.h"

namespace regarment {
namespace {

// Points per cluster of a cloud. With fewer, cells that the surface crosses stay empty and holes
// show; with more, detail is lost.
constexpr double kPointsPerCluster = 2.5;

struct Source {
  const Mesh& mesh;
  std::span<const std::uint8_t> labels, outlier;
  Box box;  // of what is shown

  bool shown(std::uint32_t vertex) const { return outlier.empty() || outlier[vertex] == 0; }
  bool shown(const Triangle& t) const { return shown(t[0]) && shown(t[1]) && shown(t[2]); }
  double diagonal() const { return (box.high - box.low).norm(); }
};

Source look_at(const Mesh& mesh, std::span<const std::uint8_t> labels,
               std::span<const std::uint8_t> outlier) {
  Source source{mesh, labels, outlier, {}};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!source.shown(std::uint32_t(i))) continue;
    check_drawable(mesh.positions[i], i);
    source.box.add(mesh.positions[i]);
  }
  return source;
}

bool collapses(const Triangle& t, const VertexClusters& clusters) {
  const std::uint32_t a = clusters.of_vertex[t[0]], b = clusters.of_vertex[t[1]],
                      c = clusters.of_vertex[t[2]];
  return a == b || b == c || c == a;
}

std::size_t shown_elements(const Source& source, const VertexClusters& clusters) {
  if (source.mesh.is_cloud()) return clusters.count;
  return std::size_t(
      std::count_if(source.mesh.triangles.begin(), source.mesh.triangles.end(),
                    [&](const Triangle& t) { return source.shown(t) && !collapses(t, clusters); }));
}

// The finest grid, to some ten per cent, that leaves at most `target` elements.
VertexClusters cluster_to(const Source& source, std::span<const Vec3> normals, double target,
                          double largest_cell, double& cell) {
  const double diagonal = source.diagonal();
  VertexClusters clusters;
  const auto count_at = [&](double size) {
    clusters = cluster_vertices(source.mesh.positions, normals, source.labels, source.outlier,
                                source.box.low, size);
    return double(shown_elements(source, clusters));
  };
  cell = std::min(diagonal / 200.0, largest_cell);
  double count = count_at(cell);
  for (int attempt = 0; attempt < 6 && (count > target || count < 0.85 * target); ++attempt) {
    // A surface has elements in proportion to 1 / cell^2.
    const double ratio = std::clamp(std::sqrt(count / (0.93 * target)), 0.25, 4.0);
    cell = std::clamp(cell * ratio, diagonal * 0x1p-18, largest_cell);
    count = count_at(cell);
  }
  while (count > target && cell < largest_cell) {
    cell = std::min(1.1 * cell, largest_cell);
    count = count_at(cell);
  }
  return clusters;
}

// Each cluster: its mean, and the vertex nearest to it.
void gather(const Source& source, const VertexClusters& clusters, std::span<const Vec3> normals,
            const Vec3& origin, DisplayMesh& display) {
  std::vector<Vec3> mean(clusters.count, Vec3::Zero()), normal(clusters.count, Vec3::Zero());
  std::vector<double> members(clusters.count, 0.0);
  const auto& positions = source.mesh.positions;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t cluster = clusters.of_vertex[i];
    if (cluster == VertexClusters::kLeftOut) continue;
    mean[cluster] += positions[i];
    members[cluster] += 1.0;
    if (!normals.empty()) normal[cluster] += normals[i];
  }
  for (std::size_t c = 0; c < clusters.count; ++c) mean[c] /= members[c];
  std::vector<double> nearest(clusters.count, std::numeric_limits<double>::infinity());
  display.source_vertex.assign(clusters.count, 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t cluster = clusters.of_vertex[i];
    if (cluster == VertexClusters::kLeftOut) continue;
    const double distance = (positions[i] - mean[cluster]).squaredNorm();
    if (distance >= nearest[cluster]) continue;
    nearest[cluster] = distance;
    display.source_vertex[cluster] = std::uint32_t(i);
  }
  for (std::size_t c = 0; c < clusters.count; ++c) {
    display.positions.push_back((mean[c] - origin).cast<float>());
    display.normals.push_back(unit_or_zero(normal[c]));
  }
}

void keep_all(const Source& source, std::span<const Vec3> normals, const Vec3& origin,
              DisplayMesh& display) {
  for (std::size_t i = 0; i < source.mesh.positions.size(); ++i) {
    // Outliers have no triangle; they stay, out of the way, so that indices stay.
    const Vec3 position =
        source.shown(std::uint32_t(i)) ? source.mesh.positions[i] : source.box.low;
    display.positions.push_back((position - origin).cast<float>());
    display.normals.push_back(unit_or_zero(normals[i]));
    display.source_vertex.push_back(std::uint32_t(i));
  }
  for (std::size_t t = 0; t < source.mesh.triangles.size(); ++t) {
    if (!source.shown(source.mesh.triangles[t])) continue;
    display.triangles.push_back(source.mesh.triangles[t]);
    display.source_triangle.push_back(std::uint32_t(t));
  }
}

DisplayMesh thin_mesh(const Source& source, const Vec3& origin, std::size_t max_elements) {
  DisplayMesh display;
  const std::vector<Triangle>& triangles = source.mesh.triangles;
  const bool own_normals = source.mesh.normals.size() == source.mesh.positions.size();
  const std::vector<Vec3> made =
      own_normals ? std::vector<Vec3>() : vertex_normals(source.mesh.positions, triangles);
  const std::vector<Vec3>& normals = own_normals ? source.mesh.normals : made;
  if (triangles.size() <= max_elements) {
    keep_all(source, normals, origin, display);
    return display;
  }
  double cell = 0.0;
  const VertexClusters clusters =
      cluster_to(source, normals, double(max_elements), 2.0 * source.diagonal(), cell);
  gather(source, clusters, normals, origin, display);
  for (std::size_t t = 0; t < triangles.size() && display.triangles.size() < max_elements; ++t) {
    if (!source.shown(triangles[t]) || collapses(triangles[t], clusters)) continue;
    const Triangle& old = triangles[t];
    display.triangles.push_back(
        {clusters.of_vertex[old[0]], clusters.of_vertex[old[1]], clusters.of_vertex[old[2]]});
    display.source_triangle.push_back(std::uint32_t(t));
  }
  return display;
}

DisplayMesh thin_cloud(const Source& source, const Vec3& origin, std::size_t max_elements) {
  DisplayMesh display;
  const std::size_t points = source.mesh.positions.size();
  const bool own_normals = source.mesh.normals.size() == points;
  const std::span<const Vec3> normals =
      own_normals ? std::span<const Vec3>(source.mesh.normals) : std::span<const Vec3>();
  const double target =
      std::max(std::min(double(max_elements), double(points) / kPointsPerCluster), 1.0);
  double cell = 0.0;
  // A handful of points stays a handful of small discs.
  VertexClusters clusters = cluster_to(source, normals, target, source.diagonal() / 20.0, cell);
  if (clusters.count > max_elements) {
    clusters = cluster_to(source, normals, target, 2.0 * source.diagonal(), cell);
  }
  gather(source, clusters, normals, origin, display);
  display.spacing = cell;
  if (!own_normals) display.normals = cloud_normals(display.positions, cell);
  return display;
}

}  // namespace

DisplayMesh make_display_mesh(const Mesh& mesh, std::span<const std::uint8_t> labels,
                              std::span<const std::uint8_t> outlier, const Vec3& origin,
                              std::size_t max_elements) {
  const Source source = look_at(mesh, labels, outlier);
  if (source.box.empty() || !(source.diagonal() > 0.0)) return {};
  return mesh.is_cloud() ? thin_cloud(source, origin, max_elements)
                         : thin_mesh(source, origin, max_elements);
}

DisplayMesh make_display_mesh(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                              const Vec3& origin) {
  DisplayMesh display;
  const std::vector<Vec3> normals = welded_normals(positions, triangles);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    check_drawable(positions[i], i);
    display.positions.push_back((positions[i] - origin).cast<float>());
    display.normals.push_back(unit_or_zero(normals[i]));
    display.source_vertex.push_back(std::uint32_t(i));
  }
  display.triangles.assign(triangles.begin(), triangles.end());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    display.source_triangle.push_back(std::uint32_t(t));
  }
  return display;
}

}  // namespace regarment
