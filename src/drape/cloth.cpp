#include "drape/cloth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "base/error.h"

namespace regarment {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// A side of a triangle, directed: from a to b, with the corner on its left.
struct Side {
  int a, b, corner, triangle;
};

std::vector<Triangle> weld(const Pattern& pattern) {
  std::vector<Triangle> welded = pattern.triangles;
  for (Triangle& t : welded)
    for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(pattern.particle[v]);
  return welded;
}

std::vector<Side> sides_of(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& t = triangles[f];
      sides.push_back({static_cast<int>(t[k]), static_cast<int>(t[(k + 1) % 3]),
                       static_cast<int>(t[(k + 2) % 3]), static_cast<int>(f)});
    }
  return sides;
}

/// Each inner side once. `springs` are sorted and hold all sides, in the order of (a, b), a < b.
std::vector<BendingElement> bending_elements(const std::vector<Triangle>& triangles,
                                             const std::vector<Spring>& springs) {
  std::vector<Side> sides = sides_of(triangles);
  const auto key = [](const Side& s) {
    return std::array{std::min(s.a, s.b), std::max(s.a, s.b), s.a, s.triangle};
  };
  std::sort(sides.begin(), sides.end(),
            [&](const Side& x, const Side& y) { return key(x) < key(y); });
  std::vector<BendingElement> elements;
  std::size_t spring = 0;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &one = sides[i], &two = sides[i + 1];
    if (one.a != two.b || one.b != two.a) continue;
    while (springs[spring].particle_a != one.a || springs[spring].particle_b != one.b) ++spring;
    BendingElement e;
    // Side `one` runs from a to b with its corner on the left: (corner, a, b) faces outwards.
    e.particles = {one.corner, two.corner, one.a, one.b};
    e.triangles = {one.triangle, two.triangle};
    e.spring = static_cast<int>(spring);
    elements.push_back(e);
  }
  return elements;
}

void take_rest_shape(const Pattern& pattern, Cloth& cloth) {
  update_rest_lengths(pattern, cloth.springs);
  const std::vector<double> areas = triangle_areas(pattern);
  for (BendingElement& e : cloth.bending) {
    e.rest_side = cloth.springs[index(e.spring)].rest_length;
    for (std::size_t k = 0; k < 2; ++k) e.rest_normals[k] = 2 * areas[index(e.triangles[k])];
  }
}

void need(bool good, const std::string& what) {
  if (!good) throw InvalidInput("cloth: " + what);
}

bool within(int i, std::size_t end) { return i >= 0 && index(i) < end; }

}  // namespace

void Cloth::check() const {
  const std::size_t n = size();
  need(n > 0, "no particles");
  need(velocities.size() == n, "one velocity per particle is needed");
  need(masses.size() == n, "one mass per particle is needed");
  for (std::size_t i = 0; i < n; ++i) {
    const std::string name = "particle " + std::to_string(i);
    need(positions[i].allFinite(), name + " has a position that is not finite");
    need(velocities[i].allFinite(), name + " has a velocity that is not finite");
    need(masses[i] > 0 && std::isfinite(masses[i]), name + " has a mass that is not positive");
  }
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) need(v < n, "a triangle names a particle that is not there");
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Spring& spring = springs[s];
    const std::string name = "spring " + std::to_string(s);
    need(within(spring.particle_a, n) && within(spring.particle_b, n) &&
             spring.particle_a < spring.particle_b,
         name + " does not join two particles in order");
    need(spring.rest_length > 0 && std::isfinite(spring.rest_length),
         name + " has a rest length that is not positive");
  }
  for (std::size_t b = 0; b < bending.size(); ++b) {
    const BendingElement& e = bending[b];
    const std::string name = "bending element " + std::to_string(b);
    std::array<int, 4> p = e.particles;
    std::sort(p.begin(), p.end());
    need(within(p.front(), n) && within(p.back(), n) &&
             std::adjacent_find(p.begin(), p.end()) == p.end(),
         name + " does not have four particles");
    need(e.rest_side > 0 && e.rest_normals[0] > 0 && e.rest_normals[1] > 0,
         name + " has a flat side or area that is not positive");
  }
}

Cloth make_cloth(const Pattern& pattern, const std::vector<Vec3>& placed, double area_density) {
  need(placed.size() == pattern.flat.size(), "one placed position per pattern vertex is needed");
  const std::size_t n = index(pattern.particle_count);
  Cloth cloth;
  cloth.positions.assign(n, Vec3::Zero());
  cloth.velocities.assign(n, Vec3::Zero());
  for (std::size_t v = 0; v < placed.size(); ++v)
    cloth.positions[index(pattern.particle[v])] = placed[v];
  cloth.triangles = weld(pattern);
  cloth.springs = springs(pattern);
  cloth.bending = bending_elements(cloth.triangles, cloth.springs);
  update_cloth(pattern, cloth, area_density);
  cloth.check();
  return cloth;
}

void update_cloth(const Pattern& pattern, Cloth& cloth, double area_density) {
  need(cloth.size() == index(pattern.particle_count) &&
           cloth.triangles.size() == pattern.triangles.size(),
       "the pattern has another topology");
  take_rest_shape(pattern, cloth);
  cloth.masses = particle_masses(pattern, area_density);
}

std::vector<Vec3> at_vertices(const Pattern& pattern, const std::vector<Vec3>& particles) {
  need(particles.size() == index(pattern.particle_count), "one position per particle is needed");
  std::vector<Vec3> out;
  out.reserve(pattern.particle.size());
  for (const int p : pattern.particle) out.push_back(particles[index(p)]);
  return out;
}

std::vector<Vec3> particle_normals(const Cloth& cloth) {
  std::vector<Vec3> normals(cloth.size(), Vec3::Zero());
  const std::vector<Vec3>& x = cloth.positions;
  for (const Triangle& t : cloth.triangles) {
    const Vec3 n = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
    for (const std::uint32_t v : t) normals[v] += n;
  }
  for (Vec3& n : normals) {
    const double length = n.norm();
    n = length > 0 ? Vec3(n / length) : Vec3::Zero();
  }
  return normals;
}

double mean_stretch(const Cloth& cloth) {
  if (cloth.springs.empty()) return 1;
  double sum = 0;
  for (const Spring& s : cloth.springs)
    sum += (cloth.positions[index(s.particle_b)] - cloth.positions[index(s.particle_a)]).norm() /
           s.rest_length;
  return sum / static_cast<double>(cloth.springs.size());
}

}  // namespace regarment
