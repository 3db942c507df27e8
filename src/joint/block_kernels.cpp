#include "joint/block_kernels.h"

#include <array>

// What is inlined into a function is compiled for that function's processor.
#define REGARMENT_INLINE inline __attribute__((always_inline))
#if defined(__x86_64__)
#define REGARMENT_WIDE __attribute__((target("avx2")))
#endif

namespace regarment {
namespace {

using Eigen::Matrix3d;
using Double4 = double __attribute__((vector_size(32), may_alias));

REGARMENT_INLINE Double4& lanes(FourNumbers& numbers) {
  return *reinterpret_cast<Double4*>(numbers.lane);
}
REGARMENT_INLINE const Double4& lanes(const FourNumbers& numbers) {
  return *reinterpret_cast<const Double4*>(numbers.lane);
}

REGARMENT_INLINE void eliminate(const FilledColumn& column, int from, const Matrix3d& inverse,
                                PaddedBlock* work, Matrix3d& out, PaddedBlock& pivot) {
  const Double4 y0 = lanes(work[from].row[0]), y1 = lanes(work[from].row[1]),
                y2 = lanes(work[from].row[2]);
  for (int p = 0; p < column.count; ++p) {
    const double* l = column.blocks[p].data();  // by columns
    PaddedBlock& at = work[column.rows[p]];
    for (int r = 0; r < 3; ++r) lanes(at.row[r]) -= l[r] * y0 + (l[3 + r] * y1 + l[6 + r] * y2);
  }
  for (FourNumbers& row : work[from].row) lanes(row) = Double4{0, 0, 0, 0};
  double* l = out.data();
  for (int c = 0; c < 3; ++c) {
    const double* i = inverse.col(c).data();
    const Double4 sum = y0 * i[0] + (y1 * i[1] + y2 * i[2]);
    for (int r = 0; r < 3; ++r) l[3 * c + r] = sum[r];
  }
  for (int r = 0; r < 3; ++r) lanes(pivot.row[r]) -= l[r] * y0 + (l[3 + r] * y1 + l[6 + r] * y2);
}

template <int kWidth>
REGARMENT_INLINE void solve(const FactorView& f, FourNumbers* x) {
  constexpr int kBlock = 3 * kWidth;
  for (int k = 0; k < f.size; ++k) {
    const FourNumbers* from = x + static_cast<std::ptrdiff_t>(k) * kBlock;
    for (int p = f.start[k]; p < f.start[k + 1]; ++p) {
      const double* l = f.lower[p].data();
      FourNumbers* to = x + static_cast<std::ptrdiff_t>(f.row[p]) * kBlock;
      for (int r = 0; r < 3; ++r)
        for (int w = 0; w < kWidth; ++w)
          lanes(to[r * kWidth + w]) -=
              l[r] * lanes(from[w]) +
              (l[3 + r] * lanes(from[kWidth + w]) + l[6 + r] * lanes(from[2 * kWidth + w]));
    }
  }
  for (int k = f.size - 1; k >= 0; --k) {
    FourNumbers* at = x + static_cast<std::ptrdiff_t>(k) * kBlock;
    const double* i = f.inverse[k].data();
    for (int w = 0; w < kWidth; ++w) {
      const Double4 x0 = lanes(at[w]), x1 = lanes(at[kWidth + w]), x2 = lanes(at[2 * kWidth + w]);
      for (int r = 0; r < 3; ++r)
        lanes(at[r * kWidth + w]) = i[r] * x0 + (i[3 + r] * x1 + i[6 + r] * x2);
    }
    for (int p = f.start[k]; p < f.start[k + 1]; ++p) {
      const double* l = f.lower[p].data();
      const FourNumbers* from = x + static_cast<std::ptrdiff_t>(f.row[p]) * kBlock;
      for (std::ptrdiff_t r = 0; r < 3; ++r)
        for (int w = 0; w < kWidth; ++w)
          lanes(at[r * kWidth + w]) -=
              l[3 * r] * lanes(from[w]) +
              (l[3 * r + 1] * lanes(from[kWidth + w]) + l[3 * r + 2] * lanes(from[2 * kWidth + w]));
    }
  }
}

using Eliminate = void(const FilledColumn&, int, const Matrix3d&, PaddedBlock*, Matrix3d&,
                       PaddedBlock&);
using Solve = void(const FactorView&, FourNumbers*);

struct Kernels {
  Eliminate* eliminate;
  std::array<Solve*, kMostWidth> solve;  // by width - 1
};

void eliminate_plain(const FilledColumn& column, int from, const Matrix3d& inverse,
                     PaddedBlock* work, Matrix3d& out, PaddedBlock& pivot) {
  eliminate(column, from, inverse, work, out, pivot);
}
template <int kWidth>
void solve_plain(const FactorView& factor, FourNumbers* x) {
  solve<kWidth>(factor, x);
}

#if defined(REGARMENT_WIDE)
REGARMENT_WIDE void eliminate_wide(const FilledColumn& column, int from, const Matrix3d& inverse,
                                   PaddedBlock* work, Matrix3d& out, PaddedBlock& pivot) {
  eliminate(column, from, inverse, work, out, pivot);
}
template <int kWidth>
REGARMENT_WIDE void solve_wide(const FactorView& factor, FourNumbers* x) {
  solve<kWidth>(factor, x);
}
#endif

const Kernels& kernels() {
  static const Kernels kChosen = [] {
#if defined(REGARMENT_WIDE)
    if (__builtin_cpu_supports("avx2"))
      return Kernels{eliminate_wide, {solve_wide<1>, solve_wide<2>, solve_wide<3>, solve_wide<4>}};
#endif
    return Kernels{eliminate_plain,
                   {solve_plain<1>, solve_plain<2>, solve_plain<3>, solve_plain<4>}};
  }();
  return kChosen;
}

}  // namespace

void eliminate_block(const FilledColumn& column, int from, const Matrix3d& inverse,
                     PaddedBlock* work, Matrix3d& out, PaddedBlock& pivot) {
  kernels().eliminate(column, from, inverse, work, out, pivot);
}

void solve_blocks(const FactorView& factor, int width, FourNumbers* x) {
  kernels().solve.at(static_cast<std::size_t>(width - 1))(factor, x);
}

}  // namespace regarment
