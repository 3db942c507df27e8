#include "fill/fill_outline.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "base/error.h"

namespace regarment {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

namespace pmp = CGAL::Polygon_mesh_processing;

// Above this many points only triangulations inside the outline's Delaunay tetrahedra are looked
// at; the search over all takes the cube of their number.
constexpr std::size_t kMostForAll = 150;
constexpr int kSmoothings = 30;  // how far the outline's own offset from the cloth reaches, rings

Point point_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Vec3 vector_of(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// Triangles over the outline alone; empty when there are none.
std::vector<std::array<int, 3>> triangulated(const std::vector<Vec3>& outline) {
  std::vector<Point> points;
  points.reserve(outline.size());
  for (const Vec3& p : outline) points.push_back(point_of(p));
  std::vector<CGAL::Triple<int, int, int>> found;
  pmp::triangulate_hole_polyline(
      points, std::back_inserter(found),
      CGAL::parameters::use_delaunay_triangulation(true).do_not_use_cubic_algorithm(outline.size() >
                                                                                    kMostForAll));
  std::vector<std::array<int, 3>> out;
  out.reserve(found.size());
  for (const auto& t : found) out.push_back({t.first, t.second, t.third});
  return out;
}

/// Whether the triangles turn as the outline does: the side from its first point to its second.
bool turns_with(const std::vector<std::array<int, 3>>& triangles) {
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == 0 && t[(k + 1) % 3] == 1) return true;
  return false;
}

/// The patch as a surface whose first vertices are the outline; nothing when it is none.
std::optional<SurfaceMesh> surface_of(const std::vector<Vec3>& outline,
                                      std::vector<std::array<int, 3>> triangles) {
  if (triangles.empty()) return std::nullopt;
  const bool turn = !turns_with(triangles);
  SurfaceMesh mesh;
  for (const Vec3& p : outline) mesh.add_vertex(point_of(p));
  for (auto& t : triangles) {
    if (turn) std::swap(t[1], t[2]);
    const auto vertex = [&](std::size_t k) {
      return SurfaceMesh::Vertex_index(static_cast<SurfaceMesh::size_type>(t[k]));
    };
    if (mesh.add_face(vertex(0), vertex(1), vertex(2)) == SurfaceMesh::null_face())
      return std::nullopt;
  }
  return mesh;
}

void refine(SurfaceMesh& mesh) {
  std::vector<SurfaceMesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  std::vector<SurfaceMesh::Face_index> new_faces;
  std::vector<SurfaceMesh::Vertex_index> new_vertices;
  pmp::refine(mesh, faces, std::back_inserter(new_faces), std::back_inserter(new_vertices));
}

Vec3 on_cloth(const ClosestPoint& cloth, const Vec3& p) {
  const ClosestHit hit = cloth.closest(p);
  return hit.found() ? hit.point : p;
}

/// Inner points onto the cloth, moved by what the outline near them lies off it.
void lay_on_cloth(const ClosestPoint& cloth, std::size_t outline, SurfaceMesh& mesh) {
  const std::size_t n = mesh.number_of_vertices();
  std::vector<Vec3> laid(n), offset(n, Vec3::Zero());
  for (const auto v : mesh.vertices()) {
    const Vec3 p = vector_of(mesh.point(v));
    laid[v] = on_cloth(cloth, p);
    if (v.idx() < outline) offset[v] = p - laid[v];
  }
  for (int k = 0; k < kSmoothings; ++k) {
    std::vector<Vec3> next = offset;
    for (const auto v : mesh.vertices()) {
      if (v.idx() < outline) continue;
      Vec3 sum = Vec3::Zero();
      int count = 0;
      for (const auto w : CGAL::vertices_around_target(v, mesh)) sum += offset[w], ++count;
      if (count > 0) next[v] = sum / count;
    }
    offset = std::move(next);
  }
  for (const auto v : mesh.vertices())
    if (v.idx() >= outline) mesh.point(v) = point_of(laid[v] + offset[v]);
}

Patch patch_of(const SurfaceMesh& mesh, std::size_t outline) {
  Patch out;
  for (const auto v : mesh.vertices())
    if (v.idx() >= outline) out.inner.push_back(vector_of(mesh.point(v)));
  for (const auto f : mesh.faces()) {
    Triangle t{};
    std::size_t k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      t[k++] = static_cast<std::uint32_t>(v);
    out.triangles.push_back(t);
  }
  return out;
}

}  // namespace

std::optional<Patch> fill_outline(const std::vector<Vec3>& outline, const ClosestPoint& cloth) {
  if (outline.size() < 3) throw InvalidInput("fill_outline: an outline has three points at least");
  std::optional<SurfaceMesh> mesh = surface_of(outline, triangulated(outline));
  if (!mesh) return std::nullopt;
  refine(*mesh);
  lay_on_cloth(cloth, outline.size(), *mesh);
  return patch_of(*mesh, outline.size());
}

}  // namespace regarment
