#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace regarment {

/// Four floats reckoned at once, by the vector extension that GCC and Clang share. Every operation
/// is the plain one of IEEE 754 per lane, so the bits are the same on every processor.
using Float4 = float __attribute__((vector_size(16)));

/// Floats reckoned side by side; N is a multiple of 4.
template <int N>
struct Lanes {
  static constexpr int kParts = N / 4;
  Float4 part[kParts];

  static Lanes all(float x) {
    Lanes lanes;
    for (Float4& p : lanes.part) p = Float4{x, x, x, x};
    return lanes;
  }
  float operator[](int lane) const { return part[lane / 4][lane % 4]; }
  void set(int lane, float x) { part[lane / 4][lane % 4] = x; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    Lanes sum;
    for (int i = 0; i < kParts; ++i) sum.part[i] = a.part[i] + b.part[i];
    return sum;
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    Lanes difference;
    for (int i = 0; i < kParts; ++i) difference.part[i] = a.part[i] - b.part[i];
    return difference;
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    Lanes product;
    for (int i = 0; i < kParts; ++i) product.part[i] = a.part[i] * b.part[i];
    return product;
  }

  /// The larger of each lane, `b` where either is NaN.
  friend Lanes max(const Lanes& a, const Lanes& b) {
    Lanes larger;
    for (int i = 0; i < kParts; ++i) {
#ifdef __SSE2__
      larger.part[i] = _mm_max_ps(a.part[i], b.part[i]);
#else
      larger.part[i] = a.part[i] > b.part[i] ? a.part[i] : b.part[i];
#endif
    }
    return larger;
  }

  friend Lanes sqrt(const Lanes& a) {
    Lanes root;
    for (int i = 0; i < kParts; ++i) {
#ifdef __SSE2__
      root.part[i] = _mm_sqrt_ps(a.part[i]);
#else
      for (int k = 0; k < 4; ++k) root.part[i][k] = __builtin_sqrtf(a.part[i][k]);
#endif
    }
    return root;
  }

  /// Bit i: lane i of `a` is not above that of `b`, or one of them is NaN.
  friend unsigned not_above(const Lanes& a, const Lanes& b) {
    unsigned bits = 0;
    for (int i = 0; i < kParts; ++i) {
#ifdef __SSE2__
      bits |= static_cast<unsigned>(_mm_movemask_ps(_mm_cmpngt_ps(a.part[i], b.part[i]))) << 4 * i;
#else
      for (int k = 0; k < 4; ++k) bits |= (a.part[i][k] > b.part[i][k] ? 0U : 1U) << (4 * i + k);
#endif
    }
    return bits;
  }
};

}  // namespace regarment
