#include "joint/flat_slopes.h"

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kStep = 1e-6;  // m

/// Coarse points with one dimension moved; empty when that makes no garment.
std::vector<Vec2> moved_points(const GarmentTemplate& garment, Dimensions dimensions,
                               const std::string& name, double step) {
  dimensions[name] += step;
  try {
    return coarse_points(garment, dimensions);
  } catch (const InvalidInput&) {
    return {};
  }
}

}  // namespace

FlatSlopes flat_slopes(const GarmentTemplate& garment, const Dimensions& dimensions,
                       const Pattern& pattern) {
  const std::vector<Vec2> here = coarse_points(garment, dimensions);
  FlatSlopes out;
  for (const Dimension& d : garment.dimensions()) {
    std::vector<Vec2> above = moved_points(garment, dimensions, d.name, kStep);
    std::vector<Vec2> below = moved_points(garment, dimensions, d.name, -kStep);
    const double way = (above.empty() ? 0 : kStep) + (below.empty() ? 0 : kStep);
    if (above.empty()) above = here;
    if (below.empty()) below = here;
    std::vector<Vec2> slope(pattern.flat.size(), Vec2::Zero());
    for (std::size_t v = 0; v < slope.size() && way > 0; ++v)
      for (int c = 0; c < 3; ++c) {
        const int p = pattern.coarse_points[v][c];
        slope[v] += pattern.barycentric[v][c] * (above[p] - below[p]) / way;
      }
    out.names.push_back(d.name);
    out.vertex.push_back(std::move(slope));
  }
  return out;
}

std::vector<double> rest_length_slopes(const FlatSlopes& slopes, const Pattern& pattern,
                                       const std::vector<Spring>& springs) {
  std::vector<double> out;
  out.reserve(springs.size() * slopes.size());
  for (const Spring& s : springs) {
    const Vec2 along = (pattern.flat[s.vertex_b] - pattern.flat[s.vertex_a]).normalized();
    for (const std::vector<Vec2>& slope : slopes.vertex)
      out.push_back(along.dot(slope[s.vertex_b] - slope[s.vertex_a]));
  }
  return out;
}

}  // namespace regarment
