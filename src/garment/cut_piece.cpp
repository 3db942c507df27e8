#include "garment/cut_piece.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/error.h"
#include "garment/plane.h"
#include "garment/template_check.h"

namespace regarment {

namespace {

constexpr double kChord = 0.003;      // m
constexpr double kOnFold = 1e-9;      // m
constexpr double kGrainShare = 0.25;  // of the way from the middle of a piece to its outline left

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Vec2 on_curve(const Vec2& a, const std::vector<Vec2>& c, const Vec2& b, double u) {
  const double v = 1.0 - u;
  if (c.size() == 1) return v * v * a + 2.0 * u * v * c[0] + u * u * b;
  return v * v * v * a + 3.0 * u * v * v * c[0] + 3.0 * u * u * v * c[1] + u * u * u * b;
}

CutEdge cut_edge(const OutlineEdge& edge) {
  CutEdge out{edge.name, !edge.is_free, edge.controls, edge.points};
  if (edge.controls.empty()) return out;
  const Vec2 &a = edge.points.front(), &b = edge.points.back();
  const int parts = std::clamp(static_cast<int>(std::ceil(cut_length(out) / kChord)), 8, 400);
  out.points = {a};
  for (int k = 1; k < parts; ++k)
    out.points.push_back(on_curve(a, edge.controls, b, static_cast<double>(k) / parts));
  out.points.push_back(b);
  return out;
}

std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::vector<CutLine> lines_of(const PanelData& panel, const ShapeData& shape,
                              const NameScope& scope) {
  const auto point = [&](int i, double side) -> Vec2 {
    const std::size_t n = shape.vertices.size();
    const Vec2 p =
        scope.metres(index(i) < n ? shape.vertices[index(i)] : shape.points[index(i) - n]);
    return {side * p.x(), p.y()};
  };
  std::vector<CutLine> lines;
  for (const ShapeLine& line : shape.lines) {
    if (line.title.empty()) continue;
    const double side = panel.mirrored ? -1.0 : 1.0;
    const Vec2 from = point(line.from, side), to = point(line.to, side);
    const Vec2 mirror(-1.0, 1.0);
    if (shape.on_fold && std::abs(from.x()) < kOnFold) {
      lines.push_back({line.title, to.cwiseProduct(mirror), to});
      continue;
    }
    lines.push_back({line.title, from, to});
    if (shape.on_fold)
      lines.push_back({line.title, from.cwiseProduct(mirror), to.cwiseProduct(mirror)});
  }
  return lines;
}

/// From `p` along `direction` to the outline, m.
double reach(const std::vector<Vec2>& outline, const Vec2& p, const Vec2& direction) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i] - p, along = outline[(i + 1) % outline.size()] - outline[i];
    const double across = direction.x() * along.y() - direction.y() * along.x();
    if (std::abs(across) < 1e-15) continue;
    const double far = (a.x() * along.y() - a.y() * along.x()) / across;
    const double share = (a.x() * direction.y() - a.y() * direction.x()) / across;
    if (far > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, far);
  }
  return nearest < 1e9 ? nearest : 0.0;
}

/// Square to the longest free edge, or upright, through the middle of the piece.
std::array<Vec2, 2> grain_of_form(const CutPiece& piece) {
  Vec2 direction(0.0, 1.0), middle = Vec2::Zero();
  double longest = 0.0;
  for (const CutEdge& edge : piece.edges) {
    if (edge.is_sewn || cut_length(edge) <= longest) continue;
    longest = cut_length(edge);
    const Vec2 along = (edge.points.back() - edge.points.front()).normalized();
    direction = Vec2(-along.y(), along.x());
  }
  const std::vector<Vec2> outline = cut_outline(piece);
  for (const Vec2& p : outline) middle += p / static_cast<double>(outline.size());
  if (direction.y() < 0.0) direction = -direction;
  const double share = 1.0 - kGrainShare;
  return {middle - share * reach(outline, middle, -direction) * direction,
          middle + share * reach(outline, middle, direction) * direction};
}

/// What the template draws for a panel of the same shape.
std::array<Vec2, 2> grain_of(const TemplateData& data, const PanelData& panel,
                             const NameScope& scope, const CutPiece& piece) {
  for (const DrawnPiece& drawn : data.pieces) {
    const PanelData& first = data.panels[index(drawn.panels.front())];
    if (first.shape != panel.shape) continue;
    const Vec2 side(first.mirrored == panel.mirrored ? 1.0 : -1.0, 1.0);
    return {scope.metres(drawn.grain_from).cwiseProduct(side),
            scope.metres(drawn.grain_to).cwiseProduct(side)};
  }
  return grain_of_form(piece);
}

/// Seen from the other side of the cloth.
void turn_over(CutPiece& piece) {
  const Vec2 mirror(-1.0, 1.0);
  const auto turn = [&](Vec2& p) { p = p.cwiseProduct(mirror); };
  for (CutEdge& edge : piece.edges) {
    std::for_each(edge.points.begin(), edge.points.end(), turn);
    std::for_each(edge.controls.begin(), edge.controls.end(), turn);
  }
  for (Notch& notch : piece.notches) {
    turn(notch.at);
    turn(notch.inward);
  }
  for (CutLine& line : piece.lines) {
    turn(line.from);
    turn(line.to);
  }
  std::for_each(piece.grain.begin(), piece.grain.end(), turn);
}

void run_clockwise(CutPiece& piece) {
  if (polygon_area(cut_outline(piece)) > 0.0) return;  // y points down
  std::reverse(piece.edges.begin(), piece.edges.end());
  for (CutEdge& edge : piece.edges) {
    std::reverse(edge.points.begin(), edge.points.end());
    std::reverse(edge.controls.begin(), edge.controls.end());
  }
}

CutPiece cut_piece(const TemplateData& data, int panel, const NameScope& scope) {
  const PanelData& info = data.panels[index(panel)];
  const ShapeData& shape = data.shapes[index(info.shape)];
  const std::vector<OutlineEdge> outline = panel_outline(data, panel, scope);
  CutPiece piece;
  piece.name = info.name;
  piece.title = in_words(info.name);
  for (const OutlineEdge& edge : outline) piece.edges.push_back(cut_edge(edge));
  piece.notches = panel_notches(data, panel, outline, scope);
  piece.lines = lines_of(info, shape, scope);
  piece.on_fold = shape.on_fold;
  piece.shape = info.shape;
  piece.turned = !shape.on_fold && info.mirrored == info.is_front;
  piece.grain = grain_of(data, info, scope, piece);
  if (!info.is_front) turn_over(piece);
  run_clockwise(piece);
  return piece;
}

}  // namespace

std::vector<CutPiece> cut_pieces(const GarmentTemplate& garment, const Dimensions& dimensions) {
  const TemplateData& data = garment.data();
  const NameScope scope(data, dimensions);
  if (const auto reason = why_impossible(data, dimensions))
    throw InvalidInput(garment.name() + ": these dimensions make no garment: " + *reason);
  std::vector<CutPiece> pieces;
  pieces.reserve(data.panels.size());
  for (int p = 0; p < static_cast<int>(data.panels.size()); ++p)
    pieces.push_back(cut_piece(data, p, scope));
  return pieces;
}

double cut_length(const CutEdge& edge) {
  double length = 0.0;
  for (std::size_t i = 1; i < edge.points.size(); ++i)
    length += (edge.points[i] - edge.points[i - 1]).norm();
  return length;
}

std::vector<Vec2> cut_outline(const CutPiece& piece) {
  std::vector<Vec2> outline;
  for (const CutEdge& edge : piece.edges)
    outline.insert(outline.end(), edge.points.begin(), edge.points.end() - 1);
  return outline;
}

}  // namespace regarment
