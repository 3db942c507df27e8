#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// A point found near a query.
struct PointNeighbour {
  std::uint32_t index = 0;        // into the points the tree was built from
  double squared_distance = 0.0;  // in the unit of the points, squared
};

/// Nearest points of a cloud, by a balanced k-d tree. Keeps its own copy of the points; may be
/// asked by many threads at once. Points must be finite and fewer than 2^32; coincident points are
/// fine. Of points equally far away those found first in the tree are kept, so a tie is decided by
/// the order of the points.
class PointTree {
 public:
  explicit PointTree(std::span<const Vec3> points);

  std::size_t size() const { return points_.size(); }

  /// The `found.size()` points nearest to `query`, nearest first. Returns how many there were
  /// (fewer only when the tree holds fewer, or no more lie nearer than `max_distance`).
  std::size_t nearest(const Vec3& query, std::span<PointNeighbour> found,
                      double max_distance = std::numeric_limits<double>::infinity()) const;

  /// All points at most `radius` from `query`, in no particular order. Replaces what `found` holds.
  void within(const Vec3& query, double radius, std::vector<PointNeighbour>& found) const;

  /// The points' indices so that points near in space are near in the list: asking in this order is
  /// fast.
  std::span<const std::uint32_t> order() const { return order_; }

 private:
  struct Node {
    double split = 0.0;
    int axis = 0;
  };
  struct Search;

  void build(std::size_t node, std::size_t begin, std::size_t end, std::span<const Vec3> points);
  void descend(std::size_t node, std::size_t begin, std::size_t end, Search& search,
               double squared_gap) const;
  void gather(std::size_t node, std::size_t begin, std::size_t end, const Vec3& query,
              double squared_radius, std::vector<PointNeighbour>& found) const;

  std::vector<Vec3> points_;          // in tree order
  std::vector<std::uint32_t> order_;  // index of each of points_ in the original list
  std::vector<Node> nodes_;           // heap order: children of i are 2i + 1 and 2i + 2
};

}  // namespace regarment
