#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "joint/block_kernels.h"

namespace regarment {

/// Symmetric matrix of 3 x 3 blocks, as couplings between n particles are; the lower triangle with
/// the diagonal is kept. The blocks that may differ from zero are set once.
class BlockTriangle {
 public:
  /// `pairs`: {a, b} in any order, each in 0 .. n-1, may repeat; a == b is left out.
  BlockTriangle(int size, const std::vector<std::array<int, 2>>& pairs);

  int size() const { return static_cast<int>(diagonal.size()); }  // n, in blocks
  void set_zero();
  /// Adds a block at row i and column j; one above the diagonal is left out, as its mirror image
  /// is added too. Undefined for a pair that was not given.
  void add(int i, int j, const Eigen::Matrix3d& block);

  std::vector<Eigen::Matrix3d> diagonal;
  std::vector<int> start;              // n + 1: where the blocks below each column's diagonal begin
  std::vector<int> row;                // ascending within a column
  std::vector<Eigen::Matrix3d> below;  // as `row`
};

/// A = L D L' of such a matrix by blocks: the order of elimination and the places of L are found
/// once, [Davis 2005, "Algorithm 849: A concise sparse Cholesky factorization package"].
class BlockFactor {
 public:
  explicit BlockFactor(const BlockTriangle& structure);

  /// False when the matrix, which must have the structure given, is not positive definite.
  bool factorize(const BlockTriangle& matrix);
  /// A x = b for each column of `b` (3 n rows), after factorize() has returned true.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

 private:
  /// A block of the upper triangle in the order of elimination.
  struct Upper {
    int row = 0;    // < its column
    int entry = 0;  // in BlockTriangle::below
    bool transposed = false;
  };

  /// Rows of L in one column, in the order in which they are eliminated: pattern_[result ..].
  int gather(const BlockTriangle& matrix, int column);

  std::vector<int> place_;   // of each block in the order of elimination
  std::vector<int> parent_;  // of the elimination tree, -1 for a root
  std::vector<std::vector<Upper>> upper_;
  std::vector<int> start_, row_, filled_;  // of L, by columns
  std::vector<Eigen::Matrix3d> lower_;     // of L, as row_
  std::vector<Eigen::Matrix3d> inverse_;   // of D's blocks
  std::vector<PaddedBlock> work_;          // all zero between columns
  std::vector<int> mark_, pattern_, path_;
};

}  // namespace regarment
