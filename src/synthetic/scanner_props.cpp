#include "synthetic/scanner_props.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "geometry/point_tree.h"
#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

constexpr std::uint32_t kSides = 24;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kTrials = 100;  // places tried for an island; a crowded scene stays without it

// A surface of revolution about the upright line through `foot`: rings of the given radii and
// heights from below to above, closed at both ends by a point.
struct Ring {
  double radius, height;
};

Mesh turned(const Vec3& foot, const std::vector<Ring>& rings) {
  Mesh mesh;
  for (const Ring& ring : rings)
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = kTurn * i / kSides;
      mesh.positions.push_back(
          foot + Vec3(ring.radius * std::sin(angle), ring.height, ring.radius * std::cos(angle)));
    }
  const auto below = static_cast<std::uint32_t>(mesh.positions.size()), above = below + 1;
  mesh.positions.push_back(foot + Vec3(0, rings.front().height, 0));
  mesh.positions.push_back(foot + Vec3(0, rings.back().height, 0));
  const auto last = static_cast<std::uint32_t>(rings.size() - 1) * kSides;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t j = (i + 1) % kSides;
    mesh.triangles.push_back({below, j, i});
    mesh.triangles.push_back({above, last + i, last + j});
    for (std::uint32_t low = 0; low < last; low += kSides) {
      mesh.triangles.push_back({low + i, low + j, low + kSides + j});
      mesh.triangles.push_back({low + i, low + kSides + j, low + kSides + i});
    }
  }
  return mesh;
}

Mesh ellipsoid(const Vec3& centre, double radius, double half_height) {
  std::vector<Ring> rings;
  constexpr int kRings = 9;
  for (int i = 1; i < kRings; ++i) {
    const double angle = std::numbers::pi * i / kRings;
    rings.push_back({radius * std::sin(angle), -half_height * std::cos(angle)});
  }
  return turned(centre, rings);
}

void add_islands(int count, double height, Random& random, ScannerScene& scene) {
  const PointTree taken(scene.positions);
  for (int i = 0; i < count; ++i) {
    const double radius = random.uniform(0.01, 0.03), half_height = random.uniform(0.01, 0.03);
    const double clear = std::max(radius, half_height) + 0.04;
    for (int trial = 0; trial < kTrials; ++trial) {
      const double angle = random.uniform(0, kTurn), out = random.uniform(0.2, 0.7);
      const Vec3 centre(out * std::sin(angle), random.uniform(0.1, height), out * std::cos(angle));
      PointNeighbour near;
      if (taken.nearest(centre, {&near, 1}, clear) > 0) continue;
      scene.add(ellipsoid(centre, radius, half_height), kOwnerNobody);
      break;
    }
  }
}

}  // namespace

void PropOptions::check() const {
  check_scanner_value("posts", posts, 0, 8);
  check_scanner_value("floor_radius", floor_radius, 0, 1.2);
  check_scanner_value("islands", islands, 0, 20);
}

void add_props(const PropOptions& options, double height, int columns, double columns_yaw,
               Random& random, ScannerScene& scene) {
  options.check();
  add_islands(options.islands, height, random, scene);
  for (int i = 0; i < options.posts; ++i) {
    const double angle =
        columns_yaw + kTurn * (i % columns + 0.5) / columns + random.uniform(-0.1, 0.1);
    const double out = random.uniform(0.75, 0.95), radius = random.uniform(0.015, 0.04);
    scene.add(turned({out * std::sin(angle), 0, out * std::cos(angle)},
                     {{radius, 0.0}, {radius, height + 0.2}}),
              kOwnerNobody);
  }
  if (options.floor_radius > 0)
    scene.add(turned(Vec3::Zero(), {{options.floor_radius, -0.02}, {options.floor_radius, 0.0}}),
              kOwnerNobody);
}

}  // namespace regarment
