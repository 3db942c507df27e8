#include "geometry/mesh_builder.h"

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

std::string text(const Place& place) {
  static constexpr const char* kUnits[] = {"line ", "byte ", "part "};
  return kUnits[static_cast<int>(place.unit)] + std::to_string(place.at);
}

}  // namespace

MeshBuilder::MeshBuilder(std::string_view name, const MeshReadLimits& limits)
    : name_(one_line(name)), limits_(limits) {}

void MeshBuilder::fail(const Place& place, const std::string& words) const {
  throw ReadError(name_ + ": " + text(place) + ": " + words);
}

void MeshBuilder::check_vertex_count(std::uint64_t count, const Place& place) const {
  if (count <= limits_.max_vertices) return;
  fail(place, std::to_string(count) + " vertices are more than the " +
                  std::to_string(limits_.max_vertices) + " that are read; thin the scan out");
}

void MeshBuilder::check_face_count(std::uint64_t count, const Place& place) const {
  if (count <= limits_.max_triangles) return;
  fail(place, std::to_string(count) + " triangles are more than the " +
                  std::to_string(limits_.max_triangles) + " that are read; simplify the mesh");
}

void MeshBuilder::refuse_vertex(double x, double y, double z, const Place& place) const {
  const std::string vertex = "vertex " + std::to_string(mesh_.positions.size());
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
    fail(place, vertex + " has a coordinate that is not a finite number; remove such vertices");
  }
  fail(place, vertex + " lies more than 1e12 from the origin; no unit makes that a scan");
}

void MeshBuilder::add_normal(double x, double y, double z) {
  const Vec3 normal(x, y, z);
  const double length = normal.stableNorm();
  const bool usable = std::isfinite(length) && length > 1e-12;
  mesh_.normals.push_back(usable ? Vec3(normal / length) : Vec3(Vec3::Zero()));
}

void MeshBuilder::refuse_corners(std::uint64_t count, const Place& place) const {
  fail(place, "face " + std::to_string(faces_) + " has " + std::to_string(count) +
                  " corners, at most " + std::to_string(kMostCorners) +
                  " are read; triangulate the mesh");
}

void MeshBuilder::add_face(std::span<const std::int64_t> corners, const Place& place) {
  if (corners.size() > kMostCorners) refuse_corners(corners.size(), place);
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner > std::int64_t{0xFFFFFFFE}) {
      fail(place, "face " + std::to_string(faces_) + " names vertex " +
                      std::to_string(corner + first_number_) +
                      ", which no file can hold; export the mesh again");
    }
    if (corner > largest_) {
      largest_ = corner;
      largest_face_ = faces_;
      largest_place_ = place;
    }
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh_.triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                               static_cast<std::uint32_t>(corners[i - 1]),
                               static_cast<std::uint32_t>(corners[i])});
  }
  if (mesh_.triangles.size() > limits_.max_triangles) {
    check_face_count(mesh_.triangles.size(), place);
  }
  ++faces_;
}

Mesh MeshBuilder::finish() {
  if (mesh_.positions.empty())
    throw ReadError(name_ + ": holds no vertices; export the scan again");
  const std::size_t vertices = mesh_.positions.size();
  if (largest_ >= static_cast<std::int64_t>(vertices)) {
    fail(largest_place_, "face " + std::to_string(largest_face_) + " names vertex " +
                             std::to_string(largest_ + first_number_) + " (counted from " +
                             std::to_string(first_number_) + "), the file has " +
                             std::to_string(vertices) + "; export the mesh again");
  }
  if (mesh_.normals.size() != vertices) mesh_.normals.clear();
  if (mesh_.colours.size() != vertices) mesh_.colours.clear();
  return std::move(mesh_);
}

}  // namespace regarment
