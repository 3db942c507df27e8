#include "garment/springs.h"

#include <algorithm>

#include "base/error.h"
#include "garment/plane.h"

namespace regarment {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double rest_length(const Pattern& pattern, const Spring& spring) {
  return (pattern.flat[index(spring.vertex_a)] - pattern.flat[index(spring.vertex_b)]).norm();
}

}  // namespace

std::vector<Spring> springs(const Pattern& pattern) {
  std::vector<Spring> all;
  all.reserve(3 * pattern.triangles.size());
  for (const Triangle& triangle : pattern.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      int a = static_cast<int>(triangle[k]), b = static_cast<int>(triangle[(k + 1) % 3]);
      if (pattern.particle[index(a)] > pattern.particle[index(b)]) std::swap(a, b);
      all.push_back({pattern.particle[index(a)], pattern.particle[index(b)], a, b, 0.0});
    }
  const auto key = [](const Spring& s) {
    return std::array{s.particle_a, s.particle_b, s.vertex_a, s.vertex_b};
  };
  std::sort(all.begin(), all.end(),
            [&](const Spring& x, const Spring& y) { return key(x) < key(y); });
  const auto same = [](const Spring& x, const Spring& y) {
    return x.particle_a == y.particle_a && x.particle_b == y.particle_b;
  };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  update_rest_lengths(pattern, all);
  return all;
}

void update_rest_lengths(const Pattern& pattern, std::vector<Spring>& springs) {
  for (Spring& spring : springs) spring.rest_length = rest_length(pattern, spring);
}

std::vector<double> triangle_areas(const Pattern& pattern) {
  std::vector<double> areas;
  areas.reserve(pattern.triangles.size());
  for (const Triangle& t : pattern.triangles) {
    const double outside = pattern.panel_is_front[index(pattern.panel[t[0]])] ? -0.5 : 0.5;
    areas.push_back(outside *
                    twice_area(pattern.flat[t[0]], pattern.flat[t[1]], pattern.flat[t[2]]));
  }
  return areas;
}

std::vector<double> particle_masses(const Pattern& pattern, double area_density) {
  if (!(area_density > 0.0)) throw InvalidInput("area_density must be positive");
  std::vector<double> masses(index(pattern.particle_count), 0.0);
  const std::vector<double> areas = triangle_areas(pattern);
  for (std::size_t i = 0; i < areas.size(); ++i)
    for (const std::uint32_t v : pattern.triangles[i])
      masses[index(pattern.particle[v])] += area_density * areas[i] / 3.0;
  return masses;
}

}  // namespace regarment
