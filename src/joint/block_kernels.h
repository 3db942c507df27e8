#pragma once

#include <Eigen/Core>

namespace regarment {

/// Four numbers at a multiple of 32 bytes.
struct alignas(32) FourNumbers {
  double lane[4] = {};
};

/// A 3 x 3 block by rows, each with a zero behind it, so that a row is one register.
struct PaddedBlock {
  FourNumbers row[3];
};

/// A column of L below its diagonal, so far as it is filled.
struct FilledColumn {
  const Eigen::Matrix3d* blocks;
  const int* rows;
  int count;
};

/// One block of L by [Davis 2005]: takes `column` times y, the block that `work` has at `from`,
/// from work's other blocks; `out` = y' `inverse`, `pivot` -= `out` y. Leaves work[from] zero.
void eliminate_block(const FilledColumn& column, int from, const Eigen::Matrix3d& inverse,
                     PaddedBlock* work, Eigen::Matrix3d& out, PaddedBlock& pivot);

/// A factor in the order of elimination: L by columns and the inverses of D's blocks.
struct FactorView {
  int size;
  const int* start;  // size + 1
  const int* row;
  const Eigen::Matrix3d* lower;
  const Eigen::Matrix3d* inverse;
};

inline constexpr int kMostWidth = 4;

/// L D L' x = x in place for 4 `width` columns at once, width 1 .. kMostWidth. `x`: of each block
/// its three rows, each of `width` times four numbers.
void solve_blocks(const FactorView& factor, int width, FourNumbers* x);

// Both are reckoned with registers of four numbers where the processor has them. Each number comes
// about by the same operations in the same order everywhere, so the bits are the same.

}  // namespace regarment
