#include "synthetic/truth_lines.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "garment/template_data.h"

namespace regarment {
namespace {

// m by which a triangle is taken larger, so that a line along its edge is cut from it.
constexpr double kEdgeSlack = 1e-8;
constexpr double kWhole = 0.99;  // share of a line that must lie on a panel; the rest is rounding

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// The part of a line inside a triangle, as shares of the line; empty when second <= first.
std::array<double, 2> clip(const PanelLine& line, const std::array<Vec2, 3>& corners) {
  std::array<double, 2> part = {0, 1};
  const double sign = cross(corners[1] - corners[0], corners[2] - corners[0]) > 0 ? 1 : -1;
  const Vec2 way = line.to - line.from;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 edge = sign * (corners[(k + 1) % 3] - corners[k]).normalized();
    const double begin = cross(edge, line.from - corners[k]) + kEdgeSlack;
    const double change = cross(edge, way);
    if (change == 0) {
      if (begin < 0) return {0, 0};
    } else if (change > 0) {
      part[0] = std::max(part[0], -begin / change);
    } else {
      part[1] = std::min(part[1], -begin / change);
    }
  }
  return part;
}

std::array<Vec2, 3> flat_corners(const Pattern& pattern, const Triangle& t) {
  return {pattern.flat[t[0]], pattern.flat[t[1]], pattern.flat[t[2]]};
}

// Flat length of a line that lies on its panel, counted per triangle, and the same as worn.
struct Covered {
  double flat = 0, worn = 0;
};

// Length on the body of a flat way within a triangle.
double worn_length(const Pattern& pattern, const std::vector<Vec3>& particles, const Triangle& t,
                   const Vec2& way) {
  const auto at = [&](std::uint32_t v) {
    return particles[static_cast<std::size_t>(pattern.particle[v])];
  };
  const std::array<Vec2, 3> flat = flat_corners(pattern, t);
  const Vec2 u = flat[1] - flat[0], v = flat[2] - flat[0];
  const double area = cross(u, v);
  return (cross(way, v) / area * (at(t[1]) - at(t[0])) +
          cross(u, way) / area * (at(t[2]) - at(t[0])))
      .norm();
}

Covered cover(const Pattern& pattern, const std::vector<Vec3>* particles, const PanelLine& line) {
  Covered out;
  const Vec2 way = line.to - line.from;
  for (const Triangle& t : pattern.triangles) {
    if (pattern.panel[t[0]] != line.panel) continue;
    const std::array<double, 2> part = clip(line, flat_corners(pattern, t));
    if (part[1] <= part[0]) continue;
    const Vec2 piece = (part[1] - part[0]) * way;
    out.flat += piece.norm();
    if (particles != nullptr) out.worn += worn_length(pattern, *particles, t, piece);
  }
  return out;
}

double distance_to(const PanelLine& line, const Vec2& p) {
  const Vec2 way = line.to - line.from;
  const double share = std::clamp((p - line.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (p - line.from - share * way).norm();
}

const MeasureArrow& arrow_of(const GarmentTemplate& garment, const std::string& name) {
  for (const MeasureArrow& arrow : garment.data().arrows) {
    if (arrow.dimension == name) return arrow;
  }
  throw InvalidInput("template " + garment.name() + " draws no line for '" + name + "'");
}

}  // namespace

std::vector<PanelLine> dimension_lines(const GarmentTemplate& garment, const Pattern& pattern,
                                       const Dimensions& dimensions, const std::string& name) {
  const MeasureArrow& arrow = arrow_of(garment, name);
  const NameScope scope(garment.data(), dimensions);
  const Vec2 from = scope.metres(arrow.from), to = scope.metres(arrow.to);
  const Vec2 mirror(-1, 1);
  std::vector<PanelLine> out;
  for (std::size_t panel = 0; panel < pattern.panel_names.size(); ++panel) {
    for (const bool mirrored : {false, true}) {
      PanelLine line{static_cast<int>(panel), from, to};
      if (mirrored) {
        line.from = from.cwiseProduct(mirror);
        line.to = to.cwiseProduct(mirror);
      }
      if (cover(pattern, nullptr, line).flat > kWhole * (to - from).norm()) out.push_back(line);
    }
  }
  return out;
}

double stretch_along(const Pattern& pattern, const std::vector<Vec3>& particles,
                     const PanelLine& line) {
  const Covered covered = cover(pattern, &particles, line);
  return covered.worn / covered.flat;
}

std::vector<int> particles_beside(const Pattern& pattern, const PanelLine& line, double distance) {
  std::vector<int> out;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    if (pattern.panel[v] != line.panel) continue;
    if (distance_to(line, pattern.flat[v]) <= distance) out.push_back(pattern.particle[v]);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace regarment
