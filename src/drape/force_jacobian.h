#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

using Mat3 = Eigen::Matrix3d;

/// A symmetric 3n x 3n matrix of 3 x 3 blocks whose pattern is fixed when it is made, so that it is
/// filled again and again in place. Blocks (i, j) and (j, i) are transposes and kept once.
class BlockMatrix {
 public:
  /// `pairs`: (i, j) with i < j < n that may be other than zero; in any order, also repeated.
  BlockMatrix(std::size_t n, std::vector<std::pair<int, int>> pairs);

  std::size_t size() const { return diagonal_.size(); }  // n
  void set_zero();

  /// Adds to block (i, i); `block` symmetric.
  void add(int i, const Mat3& block) { diagonal_[static_cast<std::size_t>(i)] += block; }
  /// Adds to block (i, j) and its transpose to (j, i). i != j, in the pattern.
  void add(int i, int j, const Mat3& block) {
    if (i < j)
      upper_[slot(i, j)] += block;
    else
      upper_[slot(j, i)] += block.transpose();
  }

  /// y = this * x. x and y: n, different vectors.
  void multiply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const;

  /// this = M - a A - b B. A and B have the pattern of this; M is diagonal.
  void combine(const std::vector<double>& diagonal, double a, const BlockMatrix& first, double b,
               const BlockMatrix& second);

  std::span<const Mat3> diagonal() const { return diagonal_; }
  Mat3 block(int i, int j) const;  // zero outside of the pattern

 private:
  std::size_t slot(int i, int j) const;

  std::vector<Mat3> diagonal_;
  std::vector<std::size_t> row_;  // n + 1, where the blocks (i, j > i) of row i begin
  std::vector<int> column_;       // ascending within a row
  std::vector<Mat3> upper_;
};

/// How the forces change, for the semi-implicit step: df/dx and df/dv. Both are kept negative
/// semidefinite by those who add to them, which keeps every step solvable.
struct ForceJacobian {
  BlockMatrix by_position;  // N/m
  BlockMatrix by_velocity;  // N s/m

  void set_zero() { by_position.set_zero(), by_velocity.set_zero(); }
};

struct Cloth;

/// Zero, with room for all pairs of particles of the springs and bending elements of `cloth`.
ForceJacobian make_jacobian(const Cloth& cloth);

}  // namespace regarment
