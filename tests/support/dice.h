#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace regarment::test {

/// Seeded numbers that are the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
  }
  /// Normal deviate by the method of Box and Muller.
  double normal(double deviation) {
    const double u = 1 - uniform(0, 1), angle = uniform(0, 2 * std::numbers::pi);
    return deviation * std::sqrt(-2 * std::log(u)) * std::cos(angle);
  }
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace regarment::test
