#include "joint/particle_mesh.h"

namespace regarment {

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
