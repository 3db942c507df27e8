#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "bench/closest_point_rivals.h"
#include "bench/measures.h"
#include "geometry/closest_point.h"
#include "render/camera.h"

namespace regarment {
namespace {

constexpr std::size_t kQuestions = 20'000, kTriangles = 400'000;
constexpr int kRounds = 5;
constexpr double kTimesCgal = 4;     // what is aimed at
constexpr double kCosine = 0.5;      // of the fit's filter by normals
constexpr double kPersonSize = 1.7;  // m, the mesh is scaled to it

/// Without what lies unused, in metres as far as that matters here.
Mesh scaled(const Mesh& mesh) {
  Mesh out;
  out.positions = mesh.positions, out.triangles = mesh.triangles;
  const Box box = bounding_box(out.positions);
  const double scale = kPersonSize / (box.high - box.low).maxCoeff();
  for (Vec3& p : out.positions) p *= scale;
  return out;
}

Finder our_finder(const Mesh& mesh) {
  const auto tree =
      std::make_shared<ClosestPoint>(std::span(mesh.positions), std::span(mesh.triangles));
  return {"ours", 0.0,
          [tree](std::span<const Question> questions, double min_cosine,
                 std::vector<double>& distances) {
            for (std::size_t i = 0; i < questions.size(); ++i) {
              ClosestFilter filter;
              filter.normal = questions[i].normal, filter.min_cosine = min_cosine;
              distances[i] = std::sqrt(tree->closest(questions[i].point, filter).squared_distance);
            }
          }};
}

void compare(const Finder& ours, const Finder& other, double mm, double min_cosine,
             const Mesh& mesh, Bench& bench) {
  const std::vector<Question> questions = in_order(ask_near(mesh, mm / 1000, kQuestions));
  std::vector<double> found(questions.size());
  const std::vector<double> seconds =
      best_in_turn({[&] { ours.ask(questions, min_cosine, found); },
                    [&] { other.ask(questions, min_cosine, found); }},
                   kRounds);
  const double each = 1e6 / static_cast<double>(questions.size());
  bench.rows.push_back({.group = "Nearest points",
                        .name = std::to_string(mesh.triangles.size()) + " triangles, " +
                                std::to_string(static_cast<int>(mm)) + " mm away" +
                                (min_cosine > -1 ? ", normals within 60 degrees" : ""),
                        .value = seconds[0] * each,
                        .unit = "us",
                        .other = other.name,
                        .other_value = seconds[1] * each,
                        .at_least = kTimesCgal,
                        .by_ratio = true});
}

}  // namespace

void measure_closest_points(const Mesh& mesh, Bench& bench) {
  if (mesh.is_cloud()) return;
  Mesh finer = scaled(mesh);
  GrowthCurve growth{"nearest points, 3 mm away", "triangles", {}, 0};
  std::vector<double> found(kQuestions);
  for (std::size_t n = finer.triangles.size(); n <= kTriangles; n = finer.triangles.size() * 2) {
    subdivide(finer, n);
    const Finder ours = our_finder(finer);
    const std::vector<Question> questions = in_order(ask_near(finer, 0.003, kQuestions));
    const double seconds = best_in_turn({[&] { ours.ask(questions, kCosine, found); }}, 3)[0];
    growth.points.push_back({static_cast<double>(finer.triangles.size()), seconds});
  }
  growth.exponent = growth_exponent(growth.points);
  bench.curves.push_back(std::move(growth));
  subdivide(finer, kTriangles);
  const Finder ours = our_finder(finer), cgal = cgal_finder(finer);
  for (const double min_cosine : {-1.0, kCosine})
    for (const double mm : {3.0, 30.0}) compare(ours, cgal, mm, min_cosine, finer, bench);
}

}  // namespace regarment
