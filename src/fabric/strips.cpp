#include "fabric/strips.h"

#include <Eigen/Dense>
#include <cmath>

#include "garment/plane.h"

namespace regarment {
namespace {

constexpr double kParallel = 0.05;  // rad within which lines run alike

// Of a line and its mirror image on one panel, the one on the triangle's side.
const DrawnLine* line_of(const std::vector<DrawnLine>& lines, int panel, const Vec2& middle) {
  const DrawnLine* out = nullptr;
  double nearest = 0;
  for (const DrawnLine& line : lines) {
    const double distance = (0.5 * (line.from + line.to) - middle).norm();
    if (line.panel != panel || (out != nullptr && distance >= nearest)) continue;
    out = &line;
    nearest = distance;
  }
  return out;
}

// How far a point of a panel lies across the strips, m.
double position_of(const DrawnLine& line, const Vec2& point) {
  const Vec2 u = line.along(), off = point - line.from;
  // Mirrored lines run the other way round; down the garment is positive on all of them.
  const double sign = line.from.x() + line.to.x() < -1e-9 ? -1 : 1;
  return sign * (u.x() * off.y() - u.y() * off.x());
}

}  // namespace

Eigen::Matrix2d flat_sides(const Pattern& pattern, const Triangle& t) {
  Eigen::Matrix2d out;
  out << pattern.flat[t[1]] - pattern.flat[t[0]], pattern.flat[t[2]] - pattern.flat[t[0]];
  return out;
}

bool run_alike(const std::vector<DrawnLine>& a, const std::vector<DrawnLine>& b) {
  return std::any_of(a.begin(), a.end(), [&](const DrawnLine& p) {
    return std::any_of(b.begin(), b.end(), [&](const DrawnLine& q) {
      const Vec2 u = p.along(), v = q.along();
      return p.panel == q.panel && std::abs(u.x() * v.y() - u.y() * v.x()) < kParallel;
    });
  });
}

std::vector<StripPiece> strip_pieces(const Pattern& pattern, const std::vector<DrawnLine>& lines) {
  std::vector<StripPiece> out;
  for (std::size_t k = 0; k < pattern.triangles.size(); ++k) {
    const Triangle& t = pattern.triangles[k];
    const Vec2 middle = (pattern.flat[t[0]] + pattern.flat[t[1]] + pattern.flat[t[2]]) / 3;
    const DrawnLine* line = line_of(lines, pattern.panel[t[0]], middle);
    const double area = 0.5 * std::abs(flat_sides(pattern, t).determinant());
    if (line == nullptr || area <= 0) continue;
    StripPiece piece{k, position_of(*line, middle), area, line->along(), {}};
    for (std::size_t c = 0; c < 3; ++c) piece.corners[c] = position_of(*line, pattern.flat[t[c]]);
    out.push_back(piece);
  }
  return out;
}

std::optional<double> level_among(const std::vector<DrawnLine>& lines,
                                  const std::vector<DrawnLine>& other) {
  if (!run_alike(lines, other)) return std::nullopt;
  for (const DrawnLine& line : other) {
    const Vec2 middle = 0.5 * (line.from + line.to);
    const DrawnLine* beside = line_of(lines, line.panel, middle);
    if (beside != nullptr) return position_of(*beside, middle);
  }
  return std::nullopt;
}

}  // namespace regarment
