#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "bench/closest_point_rivals.h"

namespace regarment {
namespace {

struct Cloud {
  std::vector<Vec3> points, normals;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3>;

// Keeps the nearest point that faces the right way.
struct FilteredNearest {
  const Cloud& cloud;
  const Question& question;
  double min_cosine;
  double best = std::numeric_limits<double>::infinity();

  using DistanceType = double;
  std::size_t size() const { return 1; }
  bool full() const { return true; }
  double worstDist() const { return best; }
  bool addPoint(double distance, std::size_t i) {
    const bool passes = min_cosine <= -1 || cloud.normals[i].dot(question.normal) >= min_cosine;
    if (passes && distance < best) best = distance;
    return true;
  }
};

struct State {
  Cloud cloud;
  std::unique_ptr<Tree> tree;
};

}  // namespace

Finder nanoflann_finder(const Mesh& mesh) {
  const auto state = std::make_shared<State>();
  state->cloud = {mesh.positions, mesh.normals};
  const double start = thread_seconds();
  state->tree =
      std::make_unique<Tree>(3, state->cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  state->tree->buildIndex();
  const double build_ms = (thread_seconds() - start) * 1e3;
  const auto ask = [state](std::span<const Question> questions, double min_cosine,
                           std::vector<double>& distances) {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      FilteredNearest nearest{state->cloud, questions[i], min_cosine};
      state->tree->findNeighbors(nearest, questions[i].point.data(), nanoflann::SearchParams());
      distances[i] = std::sqrt(nearest.best);
    }
  };
  return {"nanoflann", build_ms, ask};
}

}  // namespace regarment
