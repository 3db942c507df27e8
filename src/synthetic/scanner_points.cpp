#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/error.h"
#include "synthetic/scanner.h"
#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

template <class T>
void keep(std::vector<T>& values, std::span<const std::uint32_t> kept) {
  if (values.empty()) return;
  std::vector<T> chosen;
  chosen.reserve(kept.size());
  for (const std::uint32_t i : kept) chosen.push_back(values[i]);
  values = std::move(chosen);
}

// A point, the cube it lies in, and how far from its middle.
struct Placed {
  std::array<std::int32_t, 3> cube;  // z, y, x
  double off;
  std::uint32_t index;

  bool operator<(const Placed& other) const {
    return std::tie(cube, off, index) < std::tie(other.cube, other.off, other.index);
  }
};

}  // namespace

void keep_points(ScannedPerson& scan, std::span<const std::uint32_t> kept) {
  for (const std::uint32_t i : kept)
    if (i >= scan.labels.size()) throw InvalidInput("a point to be kept is not in the scan");
  keep(scan.cloud.positions, kept);
  keep(scan.cloud.normals, kept);
  keep(scan.cloud.colours, kept);
  keep(scan.labels, kept);
  keep(scan.particle, kept);
}

void thin_points(ScannedPerson& scan, double spacing) {
  check_scanner_value("spacing", spacing, 0.0005, 0.05);
  std::vector<Placed> placed;
  placed.reserve(scan.labels.size());
  for (std::uint32_t i = 0; i < scan.labels.size(); ++i) {
    const Vec3 scaled = scan.cloud.positions[i] / spacing;
    const Vec3 low = scaled.array().floor();
    placed.push_back({{static_cast<std::int32_t>(low.z()), static_cast<std::int32_t>(low.y()),
                       static_cast<std::int32_t>(low.x())},
                      (scaled - low - Vec3::Constant(0.5)).squaredNorm(),
                      i});
  }
  std::sort(placed.begin(), placed.end());
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < placed.size(); ++i)
    if (i == 0 || placed[i].cube != placed[i - 1].cube) kept.push_back(placed[i].index);
  keep_points(scan, kept);
}

void shuffle_points(ScannedPerson& scan, Random& random) {
  std::vector<std::uint32_t> order(scan.labels.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  for (std::size_t left = order.size(); left > 1; --left)
    std::swap(order[left - 1],
              order[static_cast<std::size_t>(random.uniform() * static_cast<double>(left))]);
  keep_points(scan, order);
}

std::vector<std::uint8_t> seen_particles(const ScannedPerson& scan, std::uint8_t label,
                                         std::size_t particles) {
  std::vector<std::uint8_t> seen(particles, 0);
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    const std::uint32_t p = scan.particle[i];
    if (scan.labels[i] != label || p == ScannedPerson::kNone) continue;
    if (p >= particles) throw InvalidInput("the scan is not of this garment: more particles");
    seen[p] = 1;
  }
  return seen;
}

}  // namespace regarment
