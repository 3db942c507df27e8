#include "synthetic/damage.h"

#include <algorithm>
#include <cmath>

#include "geometry/point_tree.h"
#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

Vec3 random_direction(Random& random) {
  Vec3 direction;
  do {
    direction = {random.normal(), random.normal(), random.normal()};
  } while (direction.norm() < 1e-6);
  return direction.normalized();
}

void make_holes(const DamageOptions& options, Random& random, ScannedPerson& scan) {
  std::vector<std::uint32_t> true_points;
  for (std::uint32_t i = 0; i < scan.labels.size(); ++i)
    if (scan.labels[i] != ScannedPerson::kOutlier) true_points.push_back(i);
  if (true_points.empty() || options.holes == 0) return;
  const PointTree tree(scan.cloud.positions);
  std::vector<std::uint8_t> gone(scan.labels.size(), 0);
  std::vector<PointNeighbour> found;
  for (int hole = 0; hole < options.holes; ++hole) {
    const auto chosen =
        static_cast<std::size_t>(random.uniform() * static_cast<double>(true_points.size()));
    Vec3 middle = scan.cloud.positions[true_points[chosen]];
    double radius = options.hole_radius;
    for (int part = 0; part < 3; ++part) {
      tree.within(middle, radius, found);
      for (const PointNeighbour& n : found) gone[n.index] = 1;
      middle += options.hole_radius * random.uniform(0.4, 1.0) * random_direction(random);
      radius = options.hole_radius * random.uniform(0.4, 0.9);
    }
  }
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < gone.size(); ++i)
    if (gone[i] == 0) kept.push_back(i);
  keep_points(scan, kept);
}

void add_stray(const DamageOptions& options, Random& random, ScannedPerson& scan) {
  const auto count = static_cast<std::size_t>(
      std::lround(options.stray * static_cast<double>(scan.labels.size())));
  if (count == 0) return;
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& p : scan.cloud.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  low -= Vec3::Constant(options.stray_reach);
  high += Vec3::Constant(options.stray_reach);
  const bool coloured = !scan.cloud.colours.empty();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 share(random.uniform(), random.uniform(), random.uniform());
    scan.cloud.positions.push_back(low + share.cwiseProduct(high - low));
    scan.cloud.normals.push_back(random_direction(random));
    if (coloured) {
      const auto grey = static_cast<std::uint8_t>(random.uniform(0, 256));
      scan.cloud.colours.push_back({grey, grey, grey});
    }
    scan.labels.push_back(ScannedPerson::kOutlier);
    scan.particle.push_back(ScannedPerson::kNone);
  }
}

}  // namespace

void DamageOptions::check() const {
  check_scanner_value("holes", holes, 0, 50);
  check_scanner_value("hole_radius", hole_radius, 0.005, 0.2);
  check_scanner_value("stray", stray, 0, 0.1);
  check_scanner_value("stray_reach", stray_reach, 0, 1);
}

void apply_damage(const DamageOptions& options, Random& random, ScannedPerson& scan) {
  options.check();
  make_holes(options, random, scan);
  add_stray(options, random, scan);
}

}  // namespace regarment
