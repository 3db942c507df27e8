#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "garment/pattern.h"
#include "support/made_person.h"

namespace regarment::test {

/// The made skirt itself as a draped garment, one particle per vertex.
struct MadeGarment {
  static constexpr int kAround = 96, kRows = 40;

  Pattern pattern;
  std::vector<Vec3> draped;

  explicit MadeGarment(const MadeSkirt& skirt, double raised = 0) {
    for (int i = 0; i <= kRows; ++i)
      for (int j = 0; j < kAround; ++j) {
        const double y = skirt.hem_y + (skirt.waist_y - skirt.hem_y) * i / kRows;
        const double phi = 2 * std::numbers::pi * j / kAround, r = skirt.radius(y);
        draped.emplace_back(r * std::sin(phi), y + raised, r * std::cos(phi));
      }
    pattern.flat.resize(draped.size());
    pattern.particle_count = static_cast<int>(draped.size());
    for (int v = 0; v < pattern.particle_count; ++v) pattern.particle.push_back(v);
    const auto at = [](int row, int column) {
      return static_cast<std::uint32_t>(row * kAround + column % kAround);
    };
    for (int i = 0; i < kRows; ++i)
      for (int j = 0; j < kAround; ++j) {
        pattern.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
        pattern.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
      }
    pattern.edges = {{"hem", "torso", {}, {}}, {"waist", "torso", {}, {}}};
    for (int j = 0; j < kAround; ++j) {
      pattern.edges[0].vertices.push_back(j);
      pattern.edges[1].vertices.push_back(kRows * kAround + j);
    }
  }
};

}  // namespace regarment::test
