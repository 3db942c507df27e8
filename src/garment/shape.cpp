#include "garment/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace regarment {

namespace {

/// Point of a curved edge at u in 0..1.
Vec2 curve_point(const Curvature& curvature, const Vec2& a, const Vec2& b,
                 const std::vector<Vec2>& params, double u) {
  if (curvature.kind == Curvature::Kind::Ellipse) {
    const double angle = u * std::numbers::pi / 2.0;
    const Vec2& centre = params[0];
    return centre + std::cos(angle) * (a - centre) + std::sin(angle) * (b - centre);
  }
  const Vec2 along = b - a;
  const Vec2 across(-along.y(), along.x());
  const auto control = [&](const Vec2& p) -> Vec2 { return a + p.x() * along + p.y() * across; };
  const double v = 1.0 - u;
  if (curvature.kind == Curvature::Kind::Quadratic)
    return v * v * a + 2.0 * u * v * control(params[0]) + u * u * b;
  return v * v * v * a + 3.0 * u * v * v * control(params[0]) +
         3.0 * u * u * v * control(params[1]) + u * u * u * b;
}

std::vector<Vec2> curve_params(const Curvature& curvature, const NameScope& scope) {
  std::vector<Vec2> params;
  for (const auto& param : curvature.params) {
    const bool is_length = curvature.kind == Curvature::Kind::Ellipse;
    params.push_back(is_length ? scope.metres(param)
                               : Vec2(scope.value(param[0]), scope.value(param[1])));
  }
  return params;
}

}  // namespace

std::vector<Vec2> shape_points(const ShapeData& shape, const NameScope& scope) {
  std::vector<Vec2> points;
  for (const auto& vertex : shape.vertices) points.push_back(scope.metres(vertex));
  for (const auto& point : shape.points) points.push_back(scope.metres(point));
  for (const ShapeEdge& edge : shape.edges) {
    if (!edge.curvature) continue;
    const Vec2 a = points[static_cast<std::size_t>(edge.from)];
    const Vec2 b = points[static_cast<std::size_t>(edge.to)];
    const std::vector<Vec2> params = curve_params(*edge.curvature, scope);
    for (int k = 1; k < edge.curvature->segments; ++k)
      points.push_back(curve_point(*edge.curvature, a, b, params,
                                   static_cast<double>(k) / edge.curvature->segments));
  }
  return points;
}

ShapeOutline shape_outline(const ShapeData& shape, const std::vector<Vec2>& points) {
  ShapeOutline outline;
  outline.points = static_cast<int>(shape.vertices.size() + shape.points.size());
  for (const ShapeEdge& edge : shape.edges) {
    std::vector<int> chain = {edge.from};
    const int samples = edge.curvature ? edge.curvature->segments - 1 : 0;
    for (int k = 0; k < samples; ++k) chain.push_back(outline.points++);
    chain.push_back(edge.to);
    outline.edges.push_back(std::move(chain));
  }
  for (const ShapeLine& line : shape.lines) outline.lines.push_back({line.from, line.to});
  if (!shape.on_fold) return outline;

  const int begin = shape.edges.back().to, end = shape.edges.front().from;
  for (std::size_t i = 0; i < shape.points.size(); ++i)
    if (shape.points[i][0].is_zero_constant())
      outline.fold.push_back(static_cast<int>(shape.vertices.size() + i));
  const auto t = [&](int i) { return points[static_cast<std::size_t>(i)].y(); };
  const bool downwards = t(begin) < t(end);
  std::sort(outline.fold.begin(), outline.fold.end(),
            [&](int a, int b) { return downwards ? t(a) < t(b) : t(a) > t(b); });
  outline.fold.insert(outline.fold.begin(), begin);
  outline.fold.push_back(end);
  return outline;
}

std::vector<int> closed_outline(const ShapeOutline& outline) {
  std::vector<int> polygon;
  for (const std::vector<int>& edge : outline.edges)
    polygon.insert(polygon.end(), edge.begin(), edge.end() - 1);
  if (!outline.fold.empty())
    polygon.insert(polygon.end(), outline.fold.begin(), outline.fold.end() - 1);
  return polygon;
}

std::vector<std::array<int, 2>> all_segments(const ShapeOutline& outline) {
  const std::vector<int> polygon = closed_outline(outline);
  std::vector<std::array<int, 2>> segments;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    segments.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  segments.insert(segments.end(), outline.lines.begin(), outline.lines.end());
  return segments;
}

}  // namespace regarment
