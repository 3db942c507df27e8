#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/random.h"

namespace regarment {

/// What a case may decide by share. Two decisions of one case do not depend on each other.
enum class CaseChoice : std::uint32_t { Wear, Kind, Damage, Build, Arms, Unit, Paint };

/// Chance for one case. What it says depends on seed, index and attempt alone, so a case can be
/// made again without those before it.
class CaseDice {
 public:
  /// `attempt`: 0, or how often the case was drawn before and given up; its shares stay the same.
  CaseDice(std::uint64_t seed, std::uint32_t index, std::uint32_t attempt)
      : seed_(seed), index_(index), random_(seed, index * kMostAttempts + attempt) {}

  static constexpr std::uint32_t kMostAttempts = 32;

  /// In [0, 1), spread evenly over neighbouring cases: any run of them holds each part in nearly
  /// its share (a Kronecker sequence of its own for each choice).
  double share(CaseChoice choice) const {
    constexpr double kPrimes[] = {2, 3, 5, 7, 11, 13, 17};
    const auto which = static_cast<std::uint32_t>(choice);
    const double begin = Random(seed_, 0xffffff00U + which).uniform();
    double whole = 0;
    return std::modf(begin + std::sqrt(kPrimes[which]) * index_, &whole);
  }
  /// Index into `weights` (adding up to 1), each as often as its weight.
  std::size_t pick(CaseChoice choice, std::span<const double> weights) const {
    double left = share(choice);
    for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
      if (left < weights[i]) return i;
      left -= weights[i];
    }
    return weights.size() - 1;
  }

  double uniform(double low, double high) { return random_.uniform(low, high); }
  bool chance(double share) { return random_.uniform() < share; }
  /// Normal, cut off at twice the standard deviation.
  double about(double mean, double deviation) {
    return mean + deviation * std::clamp(random_.normal(), -2.0, 2.0);
  }
  Random& random() { return random_; }

 private:
  std::uint64_t seed_;
  std::uint32_t index_;
  Random random_;
};

}  // namespace regarment
