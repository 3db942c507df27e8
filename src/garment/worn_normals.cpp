#include "garment/worn_normals.h"

#include <Eigen/Geometry>

namespace regarment {

std::vector<Vec3> worn_normals(const Pattern& pattern, const std::vector<Vec3>& particles) {
  constexpr double kLeast = 1e-15;  // m^2, of the triangles around a particle
  std::vector<Vec3> normals(particles.size(), Vec3::Zero());
  for (const Triangle& t : pattern.triangles) {
    const int a = pattern.particle[t[0]], b = pattern.particle[t[1]], c = pattern.particle[t[2]];
    const Vec3 n = (particles[b] - particles[a]).cross(particles[c] - particles[a]);
    normals[a] += n, normals[b] += n, normals[c] += n;
  }
  for (Vec3& n : normals) n = n.norm() > kLeast ? Vec3(n.normalized()) : Vec3::Zero();
  return normals;
}

}  // namespace regarment
