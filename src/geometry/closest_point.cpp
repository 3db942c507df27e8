#include "geometry/closest_point.h"

#include <algorithm>

#include "base/error.h"
#include "geometry/surface_element.h"

namespace regarment {
namespace {

template <class Element>
struct PlainTree {
  struct Node {
    Vec3 low, high;
    std::size_t begin = 0, end = 0, right = 0;
  };
  std::vector<Element> elements;
  std::vector<Node> nodes;

  explicit PlainTree(std::vector<Element> from) : elements(std::move(from)) {
    if (!elements.empty()) build(0, elements.size());
  }
  void build(std::size_t begin, std::size_t end) {
    const std::size_t at = nodes.size();
    Node node{elements[begin].low(), elements[begin].high(), begin, end, 0};
    for (std::size_t i = begin; i < end; ++i) {
      node.low = node.low.cwiseMin(elements[i].low());
      node.high = node.high.cwiseMax(elements[i].high());
    }
    nodes.push_back(node);
    if (end - begin <= 4) return;
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(elements.begin() + begin, elements.begin() + middle, elements.begin() + end,
                     [axis](const Element& a, const Element& b) {
                       return a.low()[axis] + a.high()[axis] < b.low()[axis] + b.high()[axis];
                     });
    build(begin, middle);
    nodes[at].right = nodes.size();
    build(middle, end);
  }
  double gap(const Node& node, const Vec3& q) const {
    return (node.low - q).cwiseMax(q - node.high).cwiseMax(0.0).squaredNorm() * (1 - 1e-12);
  }
  void search(std::size_t at, const Vec3& q, const ClosestFilter& filter, ClosestHit& best) const {
    const Node& node = nodes[at];
    if (gap(node, q) > best.squared_distance) return;
    if (node.right != 0) {
      const bool swap = gap(nodes[node.right], q) < gap(nodes[at + 1], q);
      search(swap ? node.right : at + 1, q, filter, best);
      search(swap ? at + 1 : node.right, q, filter, best);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      const Element& e = elements[i];
      if (filter.min_cosine > -1 &&
          !(!e.normal.isZero(0) && e.normal.dot(filter.normal) >= filter.min_cosine))
        continue;
      const NearestPlace place = e.nearest(q);
      if (place.squared_distance < best.squared_distance ||
          (place.squared_distance == best.squared_distance && e.index < best.element))
        best = {e.index, place.point, e.normal, place.squared_distance, place.on_border};
    }
  }
  ClosestHit closest(const Vec3& q, const ClosestFilter& filter) const {
    ClosestHit best;
    best.squared_distance = filter.max_distance * filter.max_distance;
    if (!elements.empty() && filter.max_distance >= 0) search(0, q, filter, best);
    return best.found() ? best : ClosestHit{};
  }
};

}  // namespace

template <int K>
struct KDopTree<K>::Data {
  PlainTree<TriangleElement> triangles;
  PlainTree<PointElement> points;
};

template <int K>
KDopTree<K>::KDopTree(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                      std::span<const std::uint8_t> masked)
    : data_(new Data{PlainTree<TriangleElement>(triangle_elements(positions, triangles, masked)),
                     PlainTree<PointElement>({})}) {}

template <int K>
KDopTree<K>::KDopTree(std::span<const Vec3> points, std::span<const Vec3> normals,
                      std::span<const std::uint8_t> masked)
    : data_(new Data{PlainTree<TriangleElement>({}),
                     PlainTree<PointElement>(point_elements(points, normals, masked))}) {}

template <int K>
KDopTree<K>::~KDopTree() = default;
template <int K>
KDopTree<K>::KDopTree(KDopTree&&) noexcept = default;
template <int K>
KDopTree<K>& KDopTree<K>::operator=(KDopTree&&) noexcept = default;

template <int K>
ClosestHit KDopTree<K>::closest(const Vec3& query, const ClosestFilter& filter) const {
  return empty() || !data_->triangles.elements.empty() ? data_->triangles.closest(query, filter)
                                                       : data_->points.closest(query, filter);
}

template <int K>
bool KDopTree<K>::empty() const {
  return data_->triangles.elements.empty() && data_->points.elements.empty();
}

template class KDopTree<6>;
template class KDopTree<14>;
template class KDopTree<18>;
template class KDopTree<26>;

}  // namespace regarment
