#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Whose surface a triangle of a scene is; the labels of true scans. i = 1.. is the i-th garment.
inline constexpr std::uint8_t kOwnerPerson = 0;
inline constexpr std::uint8_t kOwnerNobody = 255;  // what is no part of the dressed person

/// Everything a scanner can see: closed surfaces, triangles counter-clockwise from outside. Body
/// frame, m. Per-triangle vectors have one entry per triangle.
struct ScannerScene {
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> owner;
  // Of a garment: the pattern's triangle it came from; else kNone.
  std::vector<std::uint32_t> source;
  // 1 for the side of the cloth that lies towards the body, else 0.
  std::vector<std::uint8_t> inner;

  /// Adds a surface that is nobody's garment.
  void add(const Mesh& mesh, std::uint8_t whose);
};

struct DressedPerson;

/// The body, and each garment as a slab of cloth (scanner_cloth.h). Throws InvalidInput for more
/// than 254 garments, or one whose particles are not those of its pattern.
ScannerScene make_scene(const DressedPerson& person);

}  // namespace regarment
