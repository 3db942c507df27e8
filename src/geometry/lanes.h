#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
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
      std::array<float, 4> x, y;
      std::memcpy(x.data(), &a.part[i], sizeof(x));
      std::memcpy(y.data(), &b.part[i], sizeof(y));
      for (int k = 0; k < 4; ++k) bits |= (x[k] > y[k] ? 0U : 1U) << (4 * i + k);
#endif
    }
    return bits;
  }
};

/// How many of four bits are set.
inline int count_bits4(unsigned bits) {
  return static_cast<int>(0x4332322132212110U >> 4 * bits & 15);
}

/// Four lanes by size. The bits of a number that is not negative order as the number does, so each
/// key is a value with its lane in the two lowest bits, and no step of sorting needs a branch.
struct SortedLanes {
  std::array<float, 4> keys;  // falling; those of closed lanes last
  int nearest = 0;            // lane of the smallest that is open

  /// `values` are finite and not negative. Bit i of `open`: lane i counts.
  SortedLanes(Float4 values, unsigned open) {
    const Bits lanes{0, 1, 2, 3}, flags{1, 2, 4, 8};
    // As floats -1 and the largest.
    constexpr std::int32_t kBelow = -0x40800000, kAbove = 0x7f7fffff;
    const Bits below{kBelow, kBelow, kBelow, kBelow}, above{kAbove, kAbove, kAbove, kAbove};
    const int mask = static_cast<int>(open);
    const Bits closed = (Bits{mask, mask, mask, mask} & flags) == 0;
    Bits bits;
    std::memcpy(&bits, &values, sizeof(bits));
    bits = (bits & ~3) | lanes;
    nearest = smallest((bits & ~closed) | (closed & above));
    bits = (bits & ~closed) | (closed & below);
    std::memcpy(keys.data(), &bits, sizeof(bits));
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
  }
  /// The lane of a key.
  static int lane(float key) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &key, sizeof(bits));
    return static_cast<int>(bits & 3);
  }

 private:
  using Bits = std::int32_t __attribute__((vector_size(16)));

  static int smallest(Bits bits) {
#ifdef __SSE2__
    __m128 least;
    std::memcpy(&least, &bits, sizeof(least));
    least = _mm_min_ps(least, _mm_movehl_ps(least, least));
    least = _mm_min_ss(least, _mm_shuffle_ps(least, least, 1));
    return lane(_mm_cvtss_f32(least));
#else
    std::int32_t least = bits[0];
    for (int i = 1; i < 4; ++i) least = bits[i] < least ? bits[i] : least;
    return least & 3;
#endif
  }
  void order(int i, int j) {
#ifdef __SSE2__
    const __m128 a = _mm_set_ss(keys[i]), b = _mm_set_ss(keys[j]);
    keys[i] = _mm_cvtss_f32(_mm_max_ss(a, b));
    keys[j] = _mm_cvtss_f32(_mm_min_ss(a, b));
#else
    if (keys[i] < keys[j]) std::swap(keys[i], keys[j]);
#endif
  }
};

}  // namespace regarment
