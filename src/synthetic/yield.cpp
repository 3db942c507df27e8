#include "synthetic/yield.h"

#include <algorithm>

#include "scan/mesh_normals.h"
#include "synthetic/surface_contact.h"

namespace regarment {
namespace {

constexpr double kReach = 0.02;  // m
constexpr double kAlike = 0.3;   // least cosine between flesh and the cloth that covers it
constexpr int kRounds = 3;
constexpr double kSkinGap = 3e-4;  // m

std::vector<Triangle> triangles_of(const WornGarment& garment) {
  std::vector<Triangle> out;
  out.reserve(garment.pattern.triangles.size());
  for (const Triangle& t : garment.pattern.triangles) {
    Triangle& particles = out.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      particles[k] = static_cast<std::uint32_t>(garment.pattern.particle[t[k]]);
  }
  return out;
}

/// Moves vertices to `gap` below the cloth that covers them.
void press_in(const Obstacle& cloth, double gap, const std::vector<Triangle>& triangles,
              std::vector<Vec3>& positions) {
  const std::vector<Vec3> normals = mesh_normals(positions, triangles);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const ClosestHit hit = cloth.closest(positions[v], kReach);
    if (!hit.found() || hit.on_border || hit.normal.dot(normals[v]) < kAlike) continue;
    const double over = hit.normal.dot(positions[v] - hit.point) + gap;
    if (over > 0) positions[v] -= over * hit.normal;
  }
}

}  // namespace

void yield_to_cloth(DressedPerson& person) {
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < person.garments.size(); ++i) {
      const WornGarment& garment = person.garments[i];
      const Obstacle cloth(ObstacleKind::Below, triangles_of(garment), garment.particles,
                           garment.fabric.thickness);
      const double half = garment.fabric.thickness / 2;
      for (std::size_t k = i + 1; k < person.garments.size(); ++k) {
        WornGarment& below = person.garments[k];
        press_in(cloth, half + below.fabric.thickness / 2, triangles_of(below), below.particles);
      }
      press_in(cloth, half + kSkinGap, person.body.triangles, person.body.positions);
    }
}

}  // namespace regarment
