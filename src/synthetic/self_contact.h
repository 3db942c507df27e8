#pragma once

#include <vector>

#include "synthetic/sheet.h"

namespace regarment {

/// Keeps the folds of a sheet from passing through each other: particles stay on their side of
/// triangles that are not near to them on the sheet.
class SelfContact {
 public:
  /// `sheet` must outlive this object.
  explicit SelfContact(const Sheet& sheet);

  /// Finds what lies close to each other; good until something has moved by `kMargin`.
  void find(const std::vector<Vec3>& x);
  /// Adds what pushes pairs apart that lie too near, N, a spring of `pressure` N/m^3 times the
  /// particle's area, with friction against sliding since `before`.
  void add_forces(const std::vector<Vec3>& before, const std::vector<Vec3>& x, double pressure,
                  std::vector<Vec3>& forces) const;
  /// Moves pairs that lie too near apart at once, each side by its mass, and takes their sliding
  /// since `before` by friction.
  void separate(const std::vector<Vec3>& before, std::vector<Vec3>& x) const;
  /// Adds the greatest stiffness of these forces to each particle's, N/m.
  void add_stiffness(double pressure, std::vector<double>& stiffness) const;

  std::size_t pairs() const { return pairs_.size(); }
  double distance() const { return distance_; }

 private:
  struct Pair {
    std::uint32_t particle = 0, triangle = 0;
    Vec3 weights = Vec3::Zero();  // of the triangle's corners
    double side = 1.0;            // of the triangle's normal the particle lies on
  };
  /// A pair too near: how deep, and along which normal; depth <= 0 when it is not.
  struct Overlap {
    double depth = 0.0;
    Vec3 normal = Vec3::Zero(), slide = Vec3::Zero();
  };
  Overlap overlap(const Pair& pair, const std::vector<Vec3>& before,
                  const std::vector<Vec3>& x) const;
  void pair_up(std::uint32_t triangle, const std::vector<Vec3>& x);

  const Sheet& sheet_;
  double distance_;  // m
  std::vector<Pair> pairs_;

  // Particles sorted by the cell of a cubic grid they lie in.
  struct Grid {
    Vec3 low = Vec3::Zero();
    std::array<int, 3> size{};
    double cell = 0.0;
    std::vector<std::uint32_t> begin, particle;
    std::array<int, 3> cell_of(const Vec3& p) const;
    std::size_t index(int i, int j, int k) const {
      return (static_cast<std::size_t>(i) * size[1] + j) * size[2] + k;
    }
  } grid_;
  void sort_particles(const std::vector<Vec3>& x);
};

}  // namespace regarment
