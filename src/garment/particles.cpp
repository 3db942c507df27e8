#include "garment/particles.h"

namespace regarment {

std::vector<Vec3> particle_positions(const Pattern& pattern, const std::vector<Vec3>& vertices) {
  std::vector<Vec3> out(static_cast<std::size_t>(pattern.particle_count), Vec3::Zero());
  for (std::size_t v = 0; v < vertices.size(); ++v) out[pattern.particle[v]] = vertices[v];
  return out;
}

std::vector<Triangle> particle_triangles(const Pattern& pattern) {
  std::vector<Triangle> out;
  out.reserve(pattern.triangles.size());
  for (const Triangle& t : pattern.triangles)
    out.push_back({static_cast<std::uint32_t>(pattern.particle[t[0]]),
                   static_cast<std::uint32_t>(pattern.particle[t[1]]),
                   static_cast<std::uint32_t>(pattern.particle[t[2]])});
  return out;
}

}  // namespace regarment
