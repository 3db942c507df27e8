#include "geometry/closest_point.h"

#include <cmath>

#include "base/error.h"
#include "geometry/kdop_search.h"

namespace regarment {
namespace {

void require_usable(const Vec3& query, const ClosestFilter& filter) {
  if (!(query.array().abs() <= kLargestCoordinate).all())
    throw InvalidInput("closest point: the query is not finite or farther away than 1e15");
  if (std::isnan(filter.max_distance) || std::isnan(filter.min_cosine))
    throw InvalidInput("closest point: the filter's distance or cosine is not a number");
  if (filter.min_cosine > -1 && !(filter.normal.squaredNorm() <= 1.0002))
    throw InvalidInput("closest point: the filter's normal is longer than 1");
}

template <int K, class Elements>
ClosestHit search(const KDopNodes<K, Elements>& nodes, const Vec3& query,
                  const ClosestFilter& filter) {
  if (filter.min_cosine > -1) return KDopSearch<K, Elements, true>(nodes, query, filter).run();
  return KDopSearch<K, Elements, false>(nodes, query, filter).run();
}

}  // namespace

template <int K>
struct KDopTree<K>::Data {
  KDopNodes<K, TriangleElements> triangles;
  KDopNodes<K, PointElements> points;
};

template <int K>
KDopTree<K>::KDopTree(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                      std::span<const std::uint8_t> masked)
    : data_(new Data{KDopNodes<K, TriangleElements>(TriangleElements(positions, triangles, masked)),
                     KDopNodes<K, PointElements>({})}) {}

template <int K>
KDopTree<K>::KDopTree(std::span<const Vec3> points, std::span<const Vec3> normals,
                      std::span<const std::uint8_t> masked)
    : data_(new Data{KDopNodes<K, TriangleElements>({}),
                     KDopNodes<K, PointElements>(PointElements(points, normals, masked))}) {}

template <int K>
KDopTree<K>::~KDopTree() = default;
template <int K>
KDopTree<K>::KDopTree(KDopTree&&) noexcept = default;
template <int K>
KDopTree<K>& KDopTree<K>::operator=(KDopTree&&) noexcept = default;

template <int K>
ClosestHit KDopTree<K>::closest(const Vec3& query, const ClosestFilter& filter) const {
  require_usable(query, filter);
  if (filter.max_distance < 0) return {};
  if (data_->triangles.elements.size() > 0) return search<K>(data_->triangles, query, filter);
  if (data_->points.elements.size() > 0) return search<K>(data_->points, query, filter);
  return {};
}

template <int K>
bool KDopTree<K>::empty() const {
  return data_->triangles.elements.size() == 0 && data_->points.elements.size() == 0;
}

template class KDopTree<6>;
template class KDopTree<14>;
template class KDopTree<18>;
template class KDopTree<26>;

}  // namespace regarment
