#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <limits>

#include "bench/closest_point_rivals.h"

namespace regarment {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<Traits>;

// Walks the tree as CGAL's own Projection_traits do, but leaves out what faces another way.
class FilteredProjection {
 public:
  FilteredProjection(const Traits& traits, const Triangles& triangles,
                     const std::vector<Vec3>& normals, const Vec3& normal, double min_cosine,
                     const Kernel::Point_3& far_away)
      : traits_(traits),
        triangles_(triangles),
        normals_(normals),
        normal_(normal),
        min_cosine_(min_cosine),
        closest_(far_away) {}

  bool go_further() const { return true; }
  void intersection(const Kernel::Point_3& query, const Primitive& primitive) {
    const auto t = primitive.id() - triangles_.begin();
    if (normals_[t].dot(normal_) < min_cosine_) return;
    closest_ = traits_.closest_point_object()(query, primitive, closest_);
  }
  bool do_intersect(const Kernel::Point_3& query, const CGAL::AABB_node<Traits>& node) const {
    return traits_.compare_distance_object()(query, node.bbox(), closest_) == CGAL::SMALLER;
  }
  const Kernel::Point_3& closest() const { return closest_; }

 private:
  const Traits& traits_;
  const Triangles& triangles_;
  const std::vector<Vec3>& normals_;
  const Vec3& normal_;
  double min_cosine_;
  Kernel::Point_3 closest_;
};

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

struct State {
  Triangles triangles;
  std::vector<Vec3> normals;
  Tree tree;
};

void ask(const State& state, std::span<const Question> questions, double min_cosine,
         std::vector<double>& distances) {
  const double size = std::sqrt(CGAL::squared_distance(
      Kernel::Point_3(state.tree.bbox().xmin(), state.tree.bbox().ymin(), state.tree.bbox().zmin()),
      Kernel::Point_3(state.tree.bbox().xmax(), state.tree.bbox().ymax(),
                      state.tree.bbox().zmax())));
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Kernel::Point_3 query = to_cgal(questions[i].point);
    if (min_cosine <= -1) {
      distances[i] = std::sqrt(CGAL::squared_distance(query, state.tree.closest_point(query)));
      continue;
    }
    // The nearest of all is the answer when it passes, and it does mostly.
    const auto [nearest, id] = state.tree.closest_point_and_primitive(query);
    if (state.normals[id - state.triangles.begin()].dot(questions[i].normal) >= min_cosine) {
      distances[i] = std::sqrt(CGAL::squared_distance(query, nearest));
      continue;
    }
    const Kernel::Point_3 far_away = query + Kernel::Vector_3(10 * size, 0, 0);
    FilteredProjection walk(state.tree.traits(), state.triangles, state.normals,
                            questions[i].normal, min_cosine, far_away);
    state.tree.traversal(query, walk);
    distances[i] = walk.closest() == far_away
                       ? std::numeric_limits<double>::infinity()
                       : std::sqrt(CGAL::squared_distance(query, walk.closest()));
  }
}

}  // namespace

Finder cgal_finder(const Mesh& mesh) {
  const auto state = std::make_shared<State>();
  state->normals = face_normals(mesh);
  for (const auto& [a, b, c] : mesh.triangles)
    state->triangles.emplace_back(to_cgal(mesh.positions[a]), to_cgal(mesh.positions[b]),
                                  to_cgal(mesh.positions[c]));
  const double start = thread_seconds();
  state->tree.insert(state->triangles.begin(), state->triangles.end());
  state->tree.build();
  state->tree.accelerate_distance_queries();
  const double build_ms = (thread_seconds() - start) * 1e3;
  return {"CGAL", build_ms, [state](auto questions, double min_cosine, auto& distances) {
            ask(*state, questions, min_cosine, distances);
          }};
}

}  // namespace regarment
