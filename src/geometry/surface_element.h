#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Coordinates above this are refused: their squares must fit in a float.
constexpr double kLargestCoordinate = 1e15;

/// Where an element is nearest to a query.
struct NearestPlace {
  Vec3 point = Vec3::Zero();
  double squared_distance = 0.0;
  bool on_border = false;  // on an edge that only one triangle has, ends included
};

/// Triangles of positive area. The corners of each stand in the order of their coordinates, not of
/// the mesh, so that neighbours reckon a shared edge by the same steps and agree to the last bit.
class TriangleElements {
 public:
  TriangleElements() = default;

  /// The triangles that are not masked and have an area: more than a millionth of a millionth of
  /// the square of their longest edge, below which a normal is made of rounding alone. An edge is
  /// on the border when just one triangle that is not masked names its two vertices; one without
  /// area counts, since the surface is closed there. Throws InvalidInput when a position that is
  /// used is not finite or above the largest coordinate, an index is out of range, or
  /// `masked` has neither no entry nor one per triangle.
  TriangleElements(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                   std::span<const std::uint8_t> masked);

  /// The elements `order` names, in that order; what they share is stored in the order of its use.
  TriangleElements(const TriangleElements& from, std::span<const std::uint32_t> order);

  std::size_t size() const { return items_.size(); }
  std::uint32_t index(std::size_t i) const { return items_[i].index; }  // in the mesh
  Vec3 normal(std::size_t i) const;  // unit, by the order of the corners in the mesh
  std::array<Vec3, 3> corners(std::size_t i) const {  // sorted by x, then y, then z
    const Item& item = items_[i];
    return {places_[item.places[0]], places_[item.places[1]], places_[item.places[2]]};
  }
  NearestPlace nearest(std::size_t i, const Vec3& query) const;
  /// Says that elements from i on will be asked for soon.
  [[gnu::always_inline]] void fetch(std::size_t i) const { __builtin_prefetch(&items_[i]); }
  /// Orders elements that differ in more than the index: < 0, 0, > 0.
  int compare(std::size_t i, std::size_t j) const;

 private:
  struct Item {
    std::array<std::uint32_t, 3> places;
    std::uint32_t index = 0;
    std::uint8_t border = 0;  // bit k: corner k is on the border; bit 3 + k: the edge facing it is
    bool turned = false;      // sorting turned the triangle over
  };

  std::vector<Vec3> places_;
  std::vector<Item> items_;
};

/// Points of a cloud.
class PointElements {
 public:
  PointElements() = default;

  /// The points that are not masked. Throws InvalidInput when one of them is not finite or
  /// above the largest coordinate, its normal is neither unit (to 1e-4) nor zero, or `normals` or
  /// `masked` has neither no entry nor one per point.
  PointElements(std::span<const Vec3> points, std::span<const Vec3> normals,
                std::span<const std::uint8_t> masked);

  PointElements(const PointElements& from, std::span<const std::uint32_t> order);

  std::size_t size() const { return points_.size(); }
  std::uint32_t index(std::size_t i) const { return indices_[i]; }
  Vec3 normal(std::size_t i) const { return normals_.empty() ? Vec3::Zero() : normals_[i]; }
  std::array<Vec3, 1> corners(std::size_t i) const { return {points_[i]}; }
  NearestPlace nearest(std::size_t i, const Vec3& query) const {
    return {points_[i], (query - points_[i]).squaredNorm(), false};
  }
  [[gnu::always_inline]] void fetch(std::size_t i) const { __builtin_prefetch(&points_[i]); }
  int compare(std::size_t i, std::size_t j) const;

 private:
  std::vector<Vec3> points_, normals_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace regarment
