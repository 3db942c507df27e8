#include "garment/panel_outline.h"

#include <algorithm>
#include <numbers>

#include "garment/shape.h"

namespace regarment {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<Vec2> control_points(const Curvature& curvature, const Vec2& a, const Vec2& b,
                                 const NameScope& scope) {
  if (curvature.kind == Curvature::Kind::Ellipse) {
    // The usual cubic for a quarter circle, carried over by the affine map to the ellipse.
    const double k = 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0);
    const Vec2 centre = scope.metres(curvature.params[0]);
    return {a + k * (b - centre), b + k * (a - centre)};
  }
  const Vec2 along = b - a;
  const Vec2 across(-along.y(), along.x());
  std::vector<Vec2> controls;
  for (const auto& param : curvature.params)
    controls.push_back(a + scope.value(param[0]) * along + scope.value(param[1]) * across);
  return controls;
}

void mirror(OutlineEdge& edge) {
  for (Vec2& p : edge.points) p.x() = -p.x();
  for (Vec2& p : edge.controls) p.x() = -p.x();
}

void turn_round(OutlineEdge& edge) {
  std::reverse(edge.points.begin(), edge.points.end());
  std::reverse(edge.controls.begin(), edge.controls.end());
}

}  // namespace

std::vector<OutlineEdge> panel_outline(const TemplateData& data, int panel,
                                       const NameScope& scope) {
  const PanelData& info = data.panels[index(panel)];
  const ShapeData& shape = data.shapes[index(info.shape)];
  const std::vector<Vec2> points = shape_points(shape, scope);
  const ShapeOutline outline = shape_outline(shape, points);
  std::vector<OutlineEdge> edges;
  for (int half = 0; half < (shape.on_fold ? 2 : 1); ++half) {
    const int count = static_cast<int>(shape.edges.size());
    for (int k = 0; k < count; ++k) {
      const int e = half == 0 ? k : count - 1 - k;
      OutlineEdge edge;
      edge.ref = {panel, half, e};
      edge.name = edge_name(data, edge.ref);
      edge.is_free = std::any_of(data.free_edges.begin(), data.free_edges.end(),
                                 [&](const FreeEdge& f) { return f.name == edge.name; });
      for (const int i : outline.edges[index(e)]) edge.points.push_back(points[index(i)]);
      if (const auto& curvature = shape.edges[index(e)].curvature)
        edge.controls = control_points(*curvature, edge.points.front(), edge.points.back(), scope);
      if (info.mirrored != (half == 1)) mirror(edge);
      if (half == 1) turn_round(edge);
      edges.push_back(std::move(edge));
    }
  }
  return edges;
}

}  // namespace regarment
