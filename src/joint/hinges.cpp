#include "joint/hinges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace regarment {
namespace {

/// A triangle's corner over one of its sides, in the flat pattern.
struct Apex {
  int particle = 0;
  double height = 0;  // m over the side
  double foot = 0;    // where it stands, as a share of the way from the side's first end
  double area = 0;    // m^2
};

Apex apex_over(const Pattern& pattern, int top, int from, int to) {
  const Vec2 side = pattern.flat[to] - pattern.flat[from],
             up = pattern.flat[top] - pattern.flat[from];
  const double twice = std::abs(side.x() * up.y() - side.y() * up.x());
  return {pattern.particle[top], twice / side.norm(), up.dot(side) / side.squaredNorm(), twice / 2};
}

}  // namespace

std::vector<Hinge> hinges(const Pattern& pattern) {
  std::unordered_map<std::uint64_t, Apex> open;  // by the side's particles
  open.reserve(2 * pattern.triangles.size());
  std::vector<Hinge> out;
  for (const Triangle& t : pattern.triangles)
    for (int c = 0; c < 3; ++c) {
      int from = static_cast<int>(t[c]), to = static_cast<int>(t[(c + 1) % 3]);
      if (pattern.particle[from] > pattern.particle[to]) std::swap(from, to);
      const std::array<int, 2> side{pattern.particle[from], pattern.particle[to]};
      const Apex apex = apex_over(pattern, static_cast<int>(t[(c + 2) % 3]), from, to);
      const auto key =
          static_cast<std::uint64_t>(side[0]) << 32U | static_cast<std::uint32_t>(side[1]);
      const auto [other, first] = open.try_emplace(key, apex);
      if (first) continue;
      const Apex& a = other->second;
      const double width = (a.height + apex.height) / 3;  // across which the bend is spread
      Hinge hinge;
      hinge.particles = {a.particle, apex.particle, side[0], side[1]};
      hinge.weights = {1 / (a.height * width), 1 / (apex.height * width),
                       -((1 - a.foot) / a.height + (1 - apex.foot) / apex.height) / width,
                       -(a.foot / a.height + apex.foot / apex.height) / width};
      hinge.area = (a.area + apex.area) / 3;
      out.push_back(hinge);
      open.erase(other);
    }
  return out;
}

}  // namespace regarment
