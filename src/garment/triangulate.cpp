#include "garment/triangulate.h"

#include <algorithm>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "base/error.h"
#include "garment/plane.h"

namespace regarment {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Index of a vertex among the points given; vertices that CGAL adds have none.
struct PointIndex {
  int value = -1;
};

using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<PointIndex, Kernel,
                                                CGAL::Delaunay_mesh_vertex_base_2<Kernel>>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
using Mesher = CGAL::Delaunay_mesher_2<Cdt, Criteria>;

// CGAL bounds the longest edge; with this factor the mean edge comes out at the length asked for.
constexpr double kLongestToMeanEdge = 1.45;
// Shape bound of CGAL's mesher: no angle below 20.7 degrees where the outline allows it.
constexpr double kShapeBound = 0.125;

Cdt build(const std::vector<Vec2>& points, const std::vector<std::array<int, 2>>& segments) {
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles;
  Cdt::Face_handle hint;
  for (std::size_t i = 0; i < points.size(); ++i) {
    handles.push_back(cdt.insert(Cdt::Point(points[i].x(), points[i].y()), hint));
    hint = handles.back()->face();
    if (cdt.number_of_vertices() != i + 1)
      throw InvalidInput("two points to triangulate are the same");
    handles.back()->info().value = static_cast<int>(i);
  }
  try {
    for (const auto& segment : segments)
      cdt.insert_constraint(handles[static_cast<std::size_t>(segment[0])],
                            handles[static_cast<std::size_t>(segment[1])]);
  } catch (const Cdt::Intersection_of_constraints_exception&) {
    throw InvalidInput("two segments to triangulate cross");
  }
  return cdt;
}

/// Marks the faces that cannot be reached from outside without crossing a segment, except through
/// segments that have the region on both sides.
void mark_region(Cdt& cdt) {
  for (auto face : cdt.all_face_handles()) face->set_in_domain(true);
  std::vector<Cdt::Face_handle> open = {cdt.infinite_face()};
  open.front()->set_in_domain(false);
  while (!open.empty()) {
    const Cdt::Face_handle face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Cdt::Face_handle next = face->neighbor(i);
      if (!next->is_in_domain() || face->is_constrained(i)) continue;
      next->set_in_domain(false);
      open.push_back(next);
    }
  }
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const std::vector<Vec2>& points,
                                            const std::vector<std::array<int, 2>>& segments) {
  Cdt cdt = build(points, segments);
  mark_region(cdt);
  std::vector<std::array<int, 3>> triangles;
  for (const auto face : cdt.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    // CGAL's faces have positive area; turned round, then started at the smallest index.
    std::array<int, 3> triangle = {face->vertex(0)->info().value, face->vertex(2)->info().value,
                                   face->vertex(1)->info().value};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Vec2> refinement_points(const std::vector<Vec2>& points,
                                    const std::vector<std::array<int, 2>>& segments,
                                    double edge_length) {
  Cdt cdt = build(points, segments);
  Mesher mesher(cdt, Criteria(kShapeBound, kLongestToMeanEdge * edge_length));
  mesher.refine_mesh();
  std::vector<Vec2> added;
  for (const auto vertex : cdt.finite_vertex_handles()) {
    if (vertex->info().value >= 0) continue;
    const Vec2 p(vertex->point().x(), vertex->point().y());
    const bool on_segment = std::any_of(segments.begin(), segments.end(), [&](const auto& s) {
      return is_on_segment(p, points[static_cast<std::size_t>(s[0])],
                           points[static_cast<std::size_t>(s[1])], 0.35 * edge_length);
    });
    if (!on_segment) added.push_back(p);
  }
  std::sort(added.begin(), added.end(), [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  return added;
}

}  // namespace regarment
