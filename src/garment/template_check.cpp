#include "garment/template_check.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

#include "base/error.h"
#include "garment/plane.h"
#include "garment/sewing.h"
#include "garment/triangulate.h"

namespace regarment {

namespace {

constexpr double kNearest = 5e-4;  // m, between two points of a panel or a point and a line
constexpr double kSmallestTwiceArea = 1e-8;  // m^2, of a coarse triangle
constexpr double kSeamTolerance = 1e-6;      // relative, between the two sides of a seam
constexpr double kTrialEdge = 0.5;  // m, of the coarse mesh that shows whether the seams fit
constexpr int kMostOutlinePoints = 200;
constexpr std::size_t kMostCornerDimensions = 8;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

[[noreturn]] void fail(const TemplateData& data, const std::string& path, const std::string& what) {
  throw ReadError(data.file + ": " + path + ": " + what);
}

std::string panel_path(const ShapeData& shape) { return "/pattern/panels/" + shape.panel; }

Dimensions typical_of(const TemplateData& data) {
  Dimensions dimensions;
  for (const Dimension& d : data.dimensions) dimensions[d.name] = d.typical;
  return dimensions;
}

std::string all_dimensions_text(const TemplateData& data, const Dimensions& dimensions) {
  std::string text;
  for (const Dimension& d : data.dimensions)
    text += (text.empty() ? "" : ", ") + dimension_text(d, dimensions.at(d.name));
  return text;
}

/// Dimensions that a formula depends on, also through derived names.
std::set<std::string> dimensions_in(const TemplateData& data, const Formula& formula) {
  std::set<std::string> names;
  for (const std::string& name : formula.names()) names.insert(name);
  // Later derived names can only add earlier ones, so one pass backwards reaches all.
  for (auto derived = data.derived.rbegin(); derived != data.derived.rend(); ++derived)
    if (names.contains(derived->name))
      for (const std::string& name : derived->formula.names()) names.insert(name);
  return names;
}

std::optional<std::string> unmet_requirement(const TemplateData& data,
                                             const Dimensions& dimensions) {
  const NameScope scope(data, dimensions);
  for (const Requirement& requirement : data.requirements) {
    if (scope.value(requirement.positive) > 0.0) continue;
    const std::set<std::string> names = dimensions_in(data, requirement.positive);
    std::string given;
    for (const Dimension& d : data.dimensions)
      if (names.contains(d.name))
        given += (given.empty() ? "" : ", ") + dimension_text(d, dimensions.at(d.name));
    return requirement.message + " (given: " + given + ")";
  }
  return std::nullopt;
}

std::optional<std::string> folded_panel(const TemplateData& data, const NameScope& scope) {
  for (std::size_t s = 0; s < data.shapes.size(); ++s) {
    const std::vector<Vec2> points = shape_points(data.shapes[s], scope);
    for (const auto& t : data.coarse_triangles[s])
      if (twice_area(points[index(t[0])], points[index(t[1])], points[index(t[2])]) >
          -kSmallestTwiceArea)
        return "the panel '" + data.shapes[s].panel + "' would fold over itself";
  }
  return std::nullopt;
}

/// Lengths of the straight pieces of one side of a seam, in the order of the file.
std::vector<double> piece_lengths(const TemplateData& data, const EdgeRef& ref,
                                  const NameScope& scope) {
  const ShapeData& shape = data.shapes[index(data.panels[index(ref.panel)].shape)];
  const std::vector<Vec2> points = shape_points(shape, scope);
  const std::vector<int> chain = shape_outline(shape, points).edges[index(ref.edge)];
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    lengths.push_back((points[index(chain[i])] - points[index(chain[i + 1])]).norm());
  return lengths;
}

void check_seams(const TemplateData& data, const NameScope& scope, const std::string& where) {
  for (std::size_t i = 0; i < data.seams.size(); ++i) {
    const auto& seam = data.seams[i];
    const std::string path = "/pattern/stitches/" + std::to_string(i);
    const std::vector<double> a = piece_lengths(data, seam[0], scope);
    std::vector<double> b = piece_lengths(data, seam[1], scope);
    if (has_panel_on_left(data, seam[0]) == has_panel_on_left(data, seam[1]))
      std::reverse(b.begin(), b.end());
    if (a.size() != b.size())
      fail(data, path,
           "the two edges have " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
               " segments; a seam needs the same number");
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (std::abs(a[k] - b[k]) <= kSeamTolerance * (a[k] + b[k])) continue;
      std::ostringstream text;
      text << std::fixed << std::setprecision(2) << "the two edges are " << 100.0 * a[k] << " and "
           << 100.0 * b[k] << " cm long (" << where << "); a seam needs equal lengths";
      fail(data, path, text.str());
    }
  }
}

void check_arrows(const TemplateData& data, const NameScope& scope, const std::string& where) {
  for (std::size_t i = 0; i < data.arrows.size(); ++i) {
    const MeasureArrow& arrow = data.arrows[i];
    const double length = (scope.metres(arrow.to) - scope.metres(arrow.from)).norm();
    const double right = arrow.share * scope(arrow.dimension) / data.units_in_meter;
    if (std::abs(length - right) <= 1e-9 * (1.0 + right)) continue;
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << "the arrow is " << 100.0 * length
         << " cm long, but share times " << arrow.dimension << " is " << 100.0 * right << " cm ("
         << where << ")";
    fail(data, "/drawing/measures/" + std::to_string(i), text.str());
  }
}

void check_points(const TemplateData& data, const ShapeData& shape, const ShapeOutline& outline,
                  const std::vector<Vec2>& points) {
  const std::string path = panel_path(shape);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].cwiseAbs().maxCoeff() > 20.0) fail(data, path, "reaches more than 20 m out");
    for (std::size_t j = 0; j < i; ++j)
      if ((points[i] - points[j]).norm() < kNearest)
        fail(data, path, "two of its points lie within half a millimetre of each other");
  }
  std::vector<Vec2> polygon;
  for (const int i : closed_outline(outline)) polygon.push_back(points[index(i)]);
  const std::set<int> on_fold(outline.fold.begin(), outline.fold.end());
  const int first_sample = static_cast<int>(shape.vertices.size() + shape.points.size());
  for (int i = static_cast<int>(shape.vertices.size()); i < first_sample; ++i)
    if (!on_fold.contains(i) && !is_inside(polygon, points[index(i)]))
      fail(data, path + "/points/" + std::to_string(i - static_cast<int>(shape.vertices.size())),
           "lies outside the panel");
  if (!shape.on_fold) return;
  for (int i = 0; i < outline.points; ++i)
    if (!on_fold.contains(i) && points[index(i)].x() < kNearest)
      fail(data, path, "cut on the fold, but a point lies on the other side of the fold");
}

void check_segments(const TemplateData& data, const ShapeData& shape, const ShapeOutline& outline,
                    const std::vector<Vec2>& points) {
  const std::vector<std::array<int, 2>> segments = all_segments(outline);
  const std::size_t border = segments.size() - outline.lines.size();
  std::vector<Vec2> polygon;
  for (const int i : closed_outline(outline)) polygon.push_back(points[index(i)]);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::string path =
        panel_path(shape) + (i < border ? "" : "/lines/" + std::to_string(i - border));
    for (std::size_t j = 0; j < i; ++j) {
      if (!segments_clash(points, segments[i], segments[j], kNearest)) continue;
      fail(data, path,
           i < border ? "the outline crosses or touches itself at typical dimensions"
                      : "crosses or touches the outline or another line");
    }
    const Vec2 middle = (points[index(segments[i][0])] + points[index(segments[i][1])]) / 2.0;
    if (i >= border && !is_inside(polygon, middle)) fail(data, path, "runs outside the panel");
  }
}

void triangulate_shapes(TemplateData& data, const NameScope& scope) {
  for (const ShapeData& shape : data.shapes) {
    const std::vector<Vec2> points = shape_points(shape, scope);
    if (points.size() > index(kMostOutlinePoints))
      fail(data, panel_path(shape), "has more than 200 points, curve samples included");
    const ShapeOutline outline = shape_outline(shape, points);
    check_points(data, shape, outline, points);
    check_segments(data, shape, outline, points);
    std::vector<Vec2> polygon;
    for (const int i : closed_outline(outline)) polygon.push_back(points[index(i)]);
    data.outline_sign.push_back(polygon_area(polygon) > 0.0 ? 1 : -1);
    data.coarse_triangles.push_back(triangulate(points, all_segments(outline)));
  }
}

/// Calls `visit` with the corners of the bounds; see check_geometry in the header.
template <typename Visit>
void for_corners(const TemplateData& data, const Visit& visit) {
  const std::size_t n = data.dimensions.size();
  const auto bound = [&](std::size_t i, bool upper) {
    return upper ? data.dimensions[i].upper : data.dimensions[i].lower;
  };
  if (n <= kMostCornerDimensions) {
    for (std::size_t corner = 0; corner < (std::size_t{1} << n); ++corner) {
      Dimensions dimensions;
      for (std::size_t i = 0; i < n; ++i)
        dimensions[data.dimensions[i].name] = bound(i, (corner >> i & 1) != 0);
      visit(dimensions);
    }
    return;
  }
  for (std::size_t i = 0; i < n; ++i)
    for (const bool upper : {false, true}) {
      Dimensions dimensions = typical_of(data);
      dimensions[data.dimensions[i].name] = bound(i, upper);
      visit(dimensions);
    }
}

void check_at_bounds(const TemplateData& data) {
  for_corners(data, [&](const Dimensions& dimensions) {
    const std::string where = "at " + all_dimensions_text(data, dimensions);
    try {
      if (unmet_requirement(data, dimensions)) return;
      const NameScope scope(data, dimensions);
      if (const auto problem = folded_panel(data, scope))
        fail(data, "/pattern",
             *problem + " inside the bounds (" + where +
                 "); narrow the bounds or add a requirement");
      check_seams(data, scope, where);
      check_arrows(data, scope, where);
    } catch (const InvalidInput& error) {
      fail(data, "/pattern", std::string(error.what()) + " (" + where + ")");
    }
  });
}

void check_sewn(const TemplateData& data) {
  try {
    std::vector<ShapeMesh> meshes;
    for (const ShapeFrame& frame : shape_frames(data))
      meshes.push_back(fine_mesh(frame, divisions_for(frame, kTrialEdge), kTrialEdge));
    sew(data, meshes);
  } catch (const InvalidInput& error) {
    fail(data, "/pattern/stitches", error.what());
  }
}

}  // namespace

std::string dimension_text(const Dimension& dimension, double value) {
  std::ostringstream text;
  text << dimension.name << ' ' << std::fixed << std::setprecision(1) << 100.0 * value << " cm";
  return text.str();
}

std::optional<std::string> why_impossible(const TemplateData& data, const Dimensions& dimensions) {
  try {
    if (auto problem = unmet_requirement(data, dimensions)) return problem;
    const NameScope scope(data, dimensions);
    auto problem = folded_panel(data, scope);
    if (problem) *problem += " (given: " + all_dimensions_text(data, dimensions) + ")";
    return problem;
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

std::vector<ShapeFrame> shape_frames(const TemplateData& data) {
  const Dimensions typical = typical_of(data);
  const NameScope scope(data, typical);
  std::vector<ShapeFrame> frames;
  for (std::size_t s = 0; s < data.shapes.size(); ++s) {
    std::vector<Vec2> points = shape_points(data.shapes[s], scope);
    ShapeOutline outline = shape_outline(data.shapes[s], points);
    frames.push_back({std::move(outline), std::move(points), data.coarse_triangles[s]});
  }
  return frames;
}

void check_geometry(TemplateData& data) {
  const Dimensions typical = typical_of(data);
  try {
    if (const auto problem = unmet_requirement(data, typical))
      fail(data, "/requires", "not met at typical dimensions: " + *problem);
    const NameScope scope(data, typical);
    triangulate_shapes(data, scope);
    if (const auto problem = folded_panel(data, scope))
      fail(data, "/pattern", *problem + " at typical dimensions");
    check_seams(data, scope, "at typical dimensions");
    check_arrows(data, scope, "at typical dimensions");
    for (std::size_t i = 0; i < data.observations.size(); ++i)
      if (!(scope.value(Formula::parse(data.observations[i].equals)) > 0.0))
        fail(data, "/observations/" + std::to_string(i) + "/equals", "is not positive");
  } catch (const InvalidInput& error) {
    fail(data, "/pattern", std::string(error.what()) + " (at typical dimensions)");
  }
  check_sewn(data);
  check_at_bounds(data);
}

}  // namespace regarment
