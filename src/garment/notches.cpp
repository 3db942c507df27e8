#include "garment/notches.h"

#include <algorithm>

#include "garment/plane.h"

namespace regarment {

namespace {

constexpr double kShortestSeam = 0.06;  // m, a shorter one needs no mark
constexpr double kHalfGap = 0.005;      // m, of the two notches of a back

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double length_of(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

/// +1 when the outline runs counter-clockwise in (s, t), -1 when clockwise.
double turning(const std::vector<OutlineEdge>& outline) {
  std::vector<Vec2> polygon;
  for (const OutlineEdge& edge : outline)
    polygon.insert(polygon.end(), edge.points.begin(), edge.points.end() - 1);
  return polygon_area(polygon) > 0.0 ? 1.0 : -1.0;
}

/// The point `along` metres from the line's start, with the panel on the side told by `turn`.
Notch on_line(const std::vector<Vec2>& line, double along, double turn) {
  std::size_t i = 1;
  for (; i + 1 < line.size(); ++i) {
    const double piece = (line[i] - line[i - 1]).norm();
    if (along <= piece) break;
    along -= piece;
  }
  const Vec2 direction = (line[i] - line[i - 1]).normalized();
  return {line[i - 1] + along * direction, turn * Vec2(-direction.y(), direction.x())};
}

/// How many notches mark the seam of this edge; 0: it is not sewn.
int marks_of_seam(const TemplateData& data, const EdgeRef& ref) {
  for (const auto& seam : data.seams) {
    if (seam[0] != ref && seam[1] != ref) continue;
    const bool backs =
        !data.panels[index(seam[0].panel)].is_front && !data.panels[index(seam[1].panel)].is_front;
    return backs ? 2 : 1;
  }
  return 0;
}

void add_seams(const TemplateData& data, const std::vector<OutlineEdge>& outline,
               std::vector<Notch>& notches) {
  const double turn = turning(outline);
  for (const OutlineEdge& edge : outline) {
    const int marks = marks_of_seam(data, edge.ref);
    const double length = length_of(edge.points);
    if (marks == 0 || length < kShortestSeam) continue;
    const double gap = marks == 2 ? kHalfGap : 0.0;
    notches.push_back(on_line(edge.points, length / 2.0 - gap, turn));
    if (marks == 2) notches.push_back(on_line(edge.points, length / 2.0 + gap, turn));
  }
}

void add_fold(const ShapeData& shape, const NameScope& scope, std::vector<Notch>& notches) {
  if (!shape.on_fold) return;
  const Vec2 a = scope.metres(shape.vertices[index(shape.edges.front().from)]);
  const Vec2 b = scope.metres(shape.vertices[index(shape.edges.back().to)]);
  notches.push_back({a, (b - a).normalized()});
  notches.push_back({b, (a - b).normalized()});
}

void add_lines(const PanelData& panel, const ShapeData& shape, const NameScope& scope,
               std::vector<Notch>& notches) {
  const auto point = [&](int i) {
    const std::size_t n = shape.vertices.size();
    return scope.metres(index(i) < n ? shape.vertices[index(i)] : shape.points[index(i) - n]);
  };
  for (const ShapeLine& line : shape.lines) {
    if (line.title.empty()) continue;
    for (const auto& [end, other] :
         {std::pair(line.from, line.to), std::pair(line.to, line.from)}) {
      if (index(end) >= shape.vertices.size()) continue;
      const Vec2 at = point(end), inward = (point(other) - at).normalized();
      const Vec2 mirror(-1.0, 1.0);
      const Notch notch{at, inward};
      const Notch turned{at.cwiseProduct(mirror), inward.cwiseProduct(mirror)};
      if (shape.on_fold || !panel.mirrored) notches.push_back(notch);
      if (shape.on_fold || panel.mirrored) notches.push_back(turned);
    }
  }
}

}  // namespace

std::vector<Notch> panel_notches(const TemplateData& data, int panel,
                                 const std::vector<OutlineEdge>& outline, const NameScope& scope) {
  const PanelData& info = data.panels[index(panel)];
  const ShapeData& shape = data.shapes[index(info.shape)];
  std::vector<Notch> notches;
  add_seams(data, outline, notches);
  add_fold(shape, scope, notches);
  add_lines(info, shape, scope, notches);
  return notches;
}

}  // namespace regarment
