#include "geometry/point_tree.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "geometry/parallel.h"

namespace regarment {
namespace {

constexpr std::size_t kLeaf = 10;                  // points a leaf holds at most
constexpr std::size_t kParallelPoints = 1u << 15;  // below this a thread costs more than it brings
constexpr std::size_t kParallelNodes = 7;          // the upper three levels may use threads

std::size_t middle(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

}  // namespace

/// A running search: the best points so far, sorted by distance.
struct PointTree::Search {
  Vec3 query;
  Vec3 gap;  // per axis, from the query to the box of the node at hand
  std::span<PointNeighbour> found;
  std::size_t count = 0;
  double worst;  // squared distance a point must stay below

  void offer(std::uint32_t index, double squared_distance) {
    if (squared_distance >= worst) return;
    std::size_t at = count < found.size() ? count++ : count - 1;
    for (; at > 0 && found[at - 1].squared_distance > squared_distance; --at) {
      found[at] = found[at - 1];
    }
    found[at] = {index, squared_distance};
    if (count == found.size()) worst = found[count - 1].squared_distance;
  }
};

PointTree::PointTree(std::span<const Vec3> points) : order_(points.size()) {
  if (points.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw InvalidInput("PointTree: more than 2^32 points");
  }
  std::iota(order_.begin(), order_.end(), 0u);
  std::size_t nodes = 1;
  for (std::size_t widest = points.size(); widest > kLeaf; widest = (widest + 1) / 2) nodes *= 2;
  nodes_.resize(nodes);
  build(0, 0, points.size(), points);
  points_.resize(points.size());
  for (std::size_t i = 0; i < order_.size(); ++i) points_[i] = points[order_[i]];
}

void PointTree::build(std::size_t node, std::size_t begin, std::size_t end,
                      std::span<const Vec3> points) {
  if (end - begin <= kLeaf) return;
  Vec3 low = points[order_[begin]], high = low;
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(points[order_[i]]);
    high = high.cwiseMax(points[order_[i]]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t mid = middle(begin, end);
  std::nth_element(order_.begin() + begin, order_.begin() + mid, order_.begin() + end,
                   [&](auto a, auto b) { return points[a][axis] < points[b][axis]; });
  nodes_[node] = {points[order_[mid]][axis], axis};
  const auto child = [&](std::size_t left, std::size_t right) {
    for (std::size_t i = left; i < right; ++i) {
      i == 0 ? build(2 * node + 1, begin, mid, points) : build(2 * node + 2, mid, end, points);
    }
  };
  if (end - begin > kParallelPoints && node < kParallelNodes) {
    parallel_for(2, 1, child);
  } else {
    child(0, 2);
  }
}

std::size_t PointTree::nearest(const Vec3& query, std::span<PointNeighbour> found,
                               double max_distance) const {
  if (found.empty() || points_.empty()) return 0;
  Search search{query, Vec3::Zero(), found, 0, max_distance * max_distance};
  descend(0, 0, points_.size(), search, 0.0);
  return search.count;
}

void PointTree::descend(std::size_t node, std::size_t begin, std::size_t end, Search& search,
                        double squared_gap) const {
  if (end - begin <= kLeaf) {
    for (std::size_t i = begin; i < end; ++i) {
      search.offer(order_[i], (points_[i] - search.query).squaredNorm());
    }
    return;
  }
  const auto [split, axis] = nodes_[node];
  const std::size_t mid = middle(begin, end);
  const double offset = search.query[axis] - split;
  const bool left_first = offset < 0;
  descend(2 * node + (left_first ? 1 : 2), left_first ? begin : mid, left_first ? mid : end, search,
          squared_gap);
  // Distance to the far side's box: the gap along this axis replaces the older one.
  const double old_gap = search.gap[axis];
  const double far_gap = squared_gap - old_gap * old_gap + offset * offset;
  if (far_gap >= search.worst) return;
  search.gap[axis] = offset;
  descend(2 * node + (left_first ? 2 : 1), left_first ? mid : begin, left_first ? end : mid, search,
          far_gap);
  search.gap[axis] = old_gap;
}

void PointTree::within(const Vec3& query, double radius, std::vector<PointNeighbour>& found) const {
  found.clear();
  if (radius >= 0) gather(0, 0, points_.size(), query, radius * radius, found);
}

void PointTree::gather(std::size_t node, std::size_t begin, std::size_t end, const Vec3& query,
                       double squared_radius, std::vector<PointNeighbour>& found) const {
  if (end - begin <= kLeaf) {
    for (std::size_t i = begin; i < end; ++i) {
      const double squared = (points_[i] - query).squaredNorm();
      if (squared <= squared_radius) found.push_back({order_[i], squared});
    }
    return;
  }
  const auto [split, axis] = nodes_[node];
  const std::size_t mid = middle(begin, end);
  const double offset = query[axis] - split;
  if (offset <= 0 || offset * offset <= squared_radius) {
    gather(2 * node + 1, begin, mid, query, squared_radius, found);
  }
  if (offset >= 0 || offset * offset <= squared_radius) {
    gather(2 * node + 2, mid, end, query, squared_radius, found);
  }
}

}  // namespace regarment
