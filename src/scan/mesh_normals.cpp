#include "scan/mesh_normals.h"

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/point_tree.h"
#include "scan/visible_side.h"

namespace regarment {
namespace {

constexpr double kClearlySeen = 0.2;  // mean cosine sum per area: below, a sheet is hardly seen

/// Twice the area times the unit normal.
Vec3 area_vector(std::span<const Vec3> positions, const Triangle& t) {
  return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
}

}  // namespace

Winding outward_winding(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                        const MeshEdges& edges, std::span<const std::uint8_t> stray,
                        std::span<const Vec3> occluders, double pixel) {
  const Sheets sheets = find_sheets(triangles.size(), edges);
  std::vector<Vec3> middles(triangles.size()), normals(triangles.size());
  std::vector<double> areas(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    middles[t] = (positions[a] + positions[b] + positions[c]) / 3;
    const Vec3 area = area_vector(positions, triangles[t]);
    areas[t] = area.norm();
    if (areas[t] > 0)
      normals[t] = (sheets.turn[t] != 0 ? -1.0 : 1.0) * area / areas[t];
    else
      normals[t].setZero();
  }
  const std::vector<float> side = visible_side(middles, normals, occluders, pixel);
  std::vector<double> votes(sheets.count, 0.0), area_of(sheets.count, 0.0);
  double all_votes = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const double vote = static_cast<double>(side[t]) * areas[t];
    votes[sheets.of_triangle[t]] += vote;
    area_of[sheets.of_triangle[t]] += areas[t];
    const auto [a, b, c] = triangles[t];
    if (stray[a] == 0 && stray[b] == 0 && stray[c] == 0) all_votes += vote;
  }
  Winding winding;
  winding.turn = sheets.turn;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t sheet = sheets.of_triangle[t];
    const bool seen = std::abs(votes[sheet]) > kClearlySeen * area_of[sheet];
    if ((seen ? votes[sheet] : all_votes) < 0) winding.turn[t] ^= 1;
  }
  return winding;
}

std::vector<Vec3> mesh_normals(std::span<const Vec3> positions,
                               std::span<const Triangle> triangles) {
  std::vector<Vec3> normals(positions.size(), Vec3::Zero());
  for (const Triangle& t : triangles) {
    const Vec3 area = area_vector(positions, t);
    for (const std::uint32_t v : t) normals[v] += area;
  }
  std::vector<Vec3> places, theirs;
  std::vector<std::uint32_t> without;
  for (std::uint32_t v = 0; v < normals.size(); ++v) {
    const double length = normals[v].stableNorm();
    if (length > 0) {
      normals[v] /= length;
    } else {
      without.push_back(v);
    }
  }
  if (without.empty()) return normals;
  for (std::uint32_t v = 0; v < normals.size(); ++v) {
    if (normals[v].squaredNorm() < 0.5) continue;
    places.push_back(positions[v]);
    theirs.push_back(normals[v]);
  }
  const PointTree tree(places);
  for (const std::uint32_t v : without) {
    PointNeighbour hit;
    normals[v] =
        tree.nearest(positions[v], {&hit, 1}) == 1 ? theirs[hit.index] : Vec3(Vec3::UnitY());
  }
  return normals;
}

}  // namespace regarment
