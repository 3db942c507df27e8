#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace regarment {

/// Seeded random numbers, the same with every compiler and standard library. Streams of one seed
/// are independent of each other. Copyable; one thread at a time.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint32_t stream = 0) {
    std::seed_seq mixed{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                        stream};
    engine_.seed(mixed);
  }

  /// In [0, 1), in steps of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Mean 0, standard deviation 1 (Box and Muller).
  double normal() {
    const double u = 1 - uniform(), angle = 2 * std::numbers::pi * uniform();
    return std::sqrt(-2 * std::log(u)) * std::cos(angle);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace regarment
