#include "segmentation/colour_odds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace regarment {
namespace {

constexpr int kBins = 16;  // per channel
constexpr std::size_t kAllBins = std::size_t{kBins} * kBins * kBins;
constexpr float kSure = 2.5F;  // log-odds from which a vertex teaches its colour
constexpr double kLeastTeachers = 500;
constexpr double kMostColour = 4;  // log-odds a colour may add
constexpr double kChance = 0.7;    // share rightly told below which colours say nothing
constexpr double kClear = 0.95;    // and from which they say all

using Histogram = std::vector<double>;

std::size_t bin_of(const Colour& c) {
  std::size_t bin = 0;
  for (std::uint8_t channel : c) bin = bin * kBins + channel * kBins / 256U;
  return bin;
}

/// Each bin shares with its six neighbours: colours of a scan are noisy.
Histogram smoothed(const Histogram& h) {
  Histogram out(h.size(), 0.0);
  const std::array<int, 3> stride = {kBins * kBins, kBins, 1};
  for (int i = 0; i < static_cast<int>(h.size()); ++i) {
    if (h[i] == 0) continue;
    out[i] += 0.4 * h[i];
    for (int s : stride)
      for (int sign : {-1, 1}) {
        const int at = i / s % kBins + sign;
        out[at < 0 || at >= kBins ? i : i + sign * s] += 0.1 * h[i];
      }
  }
  return out;
}

}  // namespace

void add_colour_odds(const Scan& scan, const std::vector<std::uint8_t>& skip,
                     std::vector<float>& odds) {
  const std::vector<Colour>& colours = scan.mesh.colours;
  if (colours.empty()) return;
  std::array<Histogram, 2> seen = {Histogram(kAllBins, 0.0), Histogram(kAllBins, 0.0)};
  std::array<double, 2> teachers = {0, 0};
  const auto teaches = [&](std::size_t v) { return skip[v] == 0 && std::abs(odds[v]) > kSure; };
  for (std::size_t v = 0; v < odds.size(); ++v) {
    if (!teaches(v)) continue;
    const int side = odds[v] > 0 ? 1 : 0;
    seen[side][bin_of(colours[v])] += 1, teachers[side] += 1;
  }
  if (std::min(teachers[0], teachers[1]) < kLeastTeachers) return;
  for (Histogram& h : seen) h = smoothed(h);
  const auto says = [&](std::size_t v) {
    const std::size_t bin = bin_of(colours[v]);
    // A hundredth of a percent of either: colours hardly seen say little.
    const double ratio =
        std::log((seen[1][bin] / teachers[1] + 1e-4) / (seen[0][bin] / teachers[0] + 1e-4));
    return std::clamp(ratio, -kMostColour, kMostColour);
  };
  std::array<double, 2> right = {0, 0};
  for (std::size_t v = 0; v < odds.size(); ++v)
    if (teaches(v) && (says(v) > 0) == (odds[v] > 0)) right[odds[v] > 0 ? 1 : 0] += 1;
  const double told = 0.5 * (right[0] / teachers[0] + right[1] / teachers[1]);
  const double weight = std::clamp((told - kChance) / (kClear - kChance), 0.0, 1.0);
  if (weight == 0) return;
  for (std::size_t v = 0; v < odds.size(); ++v)
    if (skip[v] == 0) odds[v] += static_cast<float>(weight * says(v));
}

}  // namespace regarment
