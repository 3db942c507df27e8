#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// The point of a surface or cloud that is nearest to a query.
struct ClosestHit {
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::uint32_t element = kNone;  // triangle, or point of a cloud; kNone: nothing allowed is near
  Vec3 point = Vec3::Zero();      // where on it
  Vec3 normal = Vec3::Zero();     // of the triangle by its corners' order, unit; of a cloud's point
                                  // as it was given, zero without
  double squared_distance = std::numeric_limits<double>::infinity();
  // The point lies on an edge, or at an end of one, that only one unmasked triangle has. By vertex
  // numbers: weld a mesh whose triangles share none. Triangles without area count, since the
  // surface is closed where they stand; those that name a vertex twice do not. False for points.
  bool on_border = false;

  bool found() const { return element != kNone; }
};

/// What a query may find.
struct ClosestFilter {
  double max_distance = std::numeric_limits<double>::infinity();  // itself included; < 0: nothing
  // Only what faces the same way counts: normal . normal_of_element >= min_cosine. The default
  // lets everything pass. Paper, sec. 3.4.
  Vec3 normal = Vec3::Zero();  // unit, or shorter, when min_cosine > -1
  double min_cosine = -1.0;
};

/// Nearest points of a triangle mesh or a point cloud, by a tree of k-DOPs: boxes cut by K / 2
/// pairs of parallel planes (Klosowski et al. 1998), as in the paper, sec. 3.2. Each node also has
/// a cone around the normals below it, so that a normal filter leaves out whole branches and the
/// answer is still exact. Keeps its own copy; immutable, so many threads may ask at once. The
/// answer depends on the query and the input alone: of several equally near the one of the lowest
/// index is returned. Distances are reckoned in double from the positions as given. Lengths are in
/// the unit of the positions.
///
/// Cost: about 1 us a question near a surface of 100,000 triangles. A small max_distance makes it
/// less, and so does asking in an order in which neighbours follow each other.
template <int K>
class KDopTree {
  static_assert(K == 6 || K == 14 || K == 18 || K == 26);

 public:
  /// Surface of `triangles` over `positions`. Triangles with `masked[t]` != 0 do not exist, and
  /// neither do those without area, thinner than 1e-12 of their length. `masked` is empty or has
  /// one entry per triangle. Throws InvalidInput when an index is out of range, a position that an
  /// unmasked triangle uses is not finite or above 1e15, or the mask has another size.
  KDopTree(std::span<const Vec3> positions, std::span<const Triangle> triangles,
           std::span<const std::uint8_t> masked = {});
  /// Points; `normals` empty or one per point (unit, or zero: passes no normal filter); `masked`
  /// empty or one per point. Throws InvalidInput when sizes differ, an unmasked point is not finite
  /// or above 1e15, or its normal is neither unit nor zero.
  KDopTree(std::span<const Vec3> points, std::span<const Vec3> normals,
           std::span<const std::uint8_t> masked = {});
  ~KDopTree();
  KDopTree(KDopTree&&) noexcept;
  KDopTree& operator=(KDopTree&&) noexcept;

  /// The nearest allowed point, or a hit that is not found(): an empty tree, nothing within
  /// max_distance, nothing of such a normal. Throws InvalidInput when the query is not finite or
  /// above 1e15, or the filter holds what is not a number or a normal longer than 1.
  ClosestHit closest(const Vec3& query, const ClosestFilter& filter = {}) const;

  /// Whether there is nothing to find.
  bool empty() const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

extern template class KDopTree<6>;
extern template class KDopTree<14>;
extern template class KDopTree<18>;
extern template class KDopTree<26>;

/// The fastest of them on scans of 100,000 triangles; tests/benchmarks/closest_point_benchmark has
/// the figures of all four.
using ClosestPoint = KDopTree<6>;

}  // namespace regarment
