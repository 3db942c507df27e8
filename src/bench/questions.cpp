#include <Eigen/Geometry>
#include <algorithm>
#include <ctime>

#include "base/random.h"
#include "bench/closest_point_rivals.h"
#include "geometry/point_tree.h"

namespace regarment {

std::vector<Vec3> face_normals(const Mesh& mesh) {
  std::vector<Vec3> normals;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 ab = mesh.positions[b] - mesh.positions[a],
               ac = mesh.positions[c] - mesh.positions[a];
    const Vec3 across = ab.cross(ac);
    // Rounding alone must not give a normal, with which a filter could let a triangle pass.
    const bool has_area = across.norm() > 1e-12 * std::max(ab.squaredNorm(), ac.squaredNorm());
    normals.push_back(has_area ? across.normalized() : Vec3(Vec3::Zero()));
  }
  return normals;
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<Question> ask_near(const Mesh& mesh, double distance, std::size_t count) {
  const std::vector<Vec3> normals = face_normals(mesh);
  std::vector<double> area{0};
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& origin = mesh.positions[a];
    const Vec3 cross = (mesh.positions[b] - origin).cross(mesh.positions[c] - origin);
    area.push_back(area.back() + cross.norm());
  }
  Random random(1);
  std::vector<Question> questions;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at =
        std::upper_bound(area.begin() + 1, area.end() - 1, random.uniform(0, area.back()));
    const auto t = static_cast<std::size_t>(at - area.begin() - 1);
    const auto& [a, b, c] = mesh.triangles[t];
    const double root = std::sqrt(random.uniform()), v = root * random.uniform();
    const Vec3 place =
        (1 - root) * mesh.positions[a] + (root - v) * mesh.positions[b] + v * mesh.positions[c];
    questions.push_back({place + (i % 2 == 0 ? distance : -distance) * normals[t], normals[t]});
  }
  return questions;
}

std::vector<Question> in_order(const std::vector<Question>& questions) {
  std::vector<Vec3> points;
  points.reserve(questions.size());
  for (const Question& question : questions) points.push_back(question.point);
  std::vector<Question> ordered;
  const PointTree tree(points);
  for (const std::uint32_t i : tree.order()) ordered.push_back(questions[i]);
  return ordered;
}

}  // namespace regarment
