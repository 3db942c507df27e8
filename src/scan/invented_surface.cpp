#include "scan/invented_surface.h"

#include <algorithm>
#include <numeric>

#include "scan/robust.h"

namespace regarment {
namespace {

// Of the median edge length. Meshers that keep edges within a bound reach 1.25 of it.
constexpr double kLong = 1.35;    // edges of invented surface
constexpr double kLonger = 1.15;  // on average over a neighbourhood of it
constexpr double kEven = 1.35;    // nine in ten edges of an even mesh are shorter
constexpr int kRounds = 3;        // of averaging over neighbours
constexpr int kFewest = 3;        // places with long edges that make a region

/// Mean length of the edges at each position over the median of these; 0 without triangles.
std::vector<double> relative_lengths(std::span<const Vec3> positions,
                                     std::span<const Triangle> triangles) {
  std::vector<double> sums(positions.size(), 0), counts(positions.size(), 0);
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      const double length = (positions[a] - positions[b]).norm();
      for (const std::uint32_t v : {a, b}) {
        sums[v] += length;
        counts[v] += 1;
      }
    }
  }
  std::vector<double> used;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (counts[v] == 0) continue;
    sums[v] /= counts[v];
    used.push_back(sums[v]);
  }
  const double usual = quantile(std::move(used), 0.5);
  for (double& length : sums) length = usual > 0 ? length / usual : 0;
  return sums;
}

/// The mean over each position and its neighbours.
std::vector<double> averaged(const std::vector<double>& values,
                             std::span<const Triangle> triangles) {
  std::vector<double> sums = values, counts(values.size(), 1);
  // Inside of a sheet each neighbour comes by two triangles; so does the position itself.
  for (std::size_t v = 0; v < sums.size(); ++v) {
    sums[v] *= 2;
    counts[v] = 2;
  }
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      sums[t[i]] += values[t[(i + 1) % 3]] + values[t[(i + 2) % 3]];
      counts[t[i]] += 2;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= counts[v];
  return sums;
}

/// Each position's root among candidates joined by edges.
class Regions {
 public:
  explicit Regions(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t one = root(a), other = root(b);
    parent_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<std::uint8_t> find_invented(std::span<const Vec3> positions,
                                        std::span<const Triangle> triangles) {
  std::vector<std::uint8_t> invented(positions.size(), 0);
  const std::vector<double> lengths = relative_lengths(positions, triangles);
  std::vector<double> used;
  std::copy_if(lengths.begin(), lengths.end(), std::back_inserter(used),
               [](double length) { return length > 0; });
  if (quantile(std::move(used), 0.9) > kEven) return invented;
  std::vector<double> mean = lengths;
  for (int round = 0; round < kRounds; ++round) mean = averaged(mean, triangles);
  for (std::size_t v = 0; v < invented.size(); ++v) {
    invented[v] = lengths[v] > kLong || mean[v] > kLonger ? 1 : 0;
  }
  Regions regions(positions.size());
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (invented[a] != 0 && invented[b] != 0) regions.join(a, b);
    }
  }
  std::vector<int> seeds(positions.size(), 0);
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (lengths[v] > kLong) ++seeds[regions.root(v)];
  }
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (seeds[regions.root(v)] < kFewest) invented[v] = 0;
  }
  return invented;
}

}  // namespace regarment
