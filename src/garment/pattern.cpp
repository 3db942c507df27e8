#include "garment/pattern.h"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "base/error.h"
#include "garment/plane.h"
#include "garment/sewing.h"
#include "garment/template_check.h"

namespace regarment {

namespace {

constexpr double kShortestEdge = 0.002, kLongestEdge = 0.5;  // m
constexpr double kMostVertices = 1e6;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Vertices the pattern will have: equilateral triangles of this edge length, two per vertex.
double expected_vertices(const TemplateData& data, const std::vector<ShapeFrame>& frames,
                         double edge_length) {
  double area = 0.0;
  for (const PanelData& panel : data.panels) {
    const ShapeFrame& frame = frames[index(panel.shape)];
    const double halves = data.shapes[index(panel.shape)].on_fold ? 2.0 : 1.0;
    for (const auto& t : frame.triangles)
      area -= halves / 2.0 *
              twice_area(frame.points[index(t[0])], frame.points[index(t[1])],
                         frame.points[index(t[2])]);
  }
  return area / (edge_length * edge_length * std::sqrt(3.0) / 2.0);
}

/// How edges are divided: by their length, but the two sides of a seam alike.
std::vector<Divisions> divide_alike(const TemplateData& data, const std::vector<ShapeFrame>& frames,
                                    double edge_length) {
  std::vector<Divisions> divisions;
  divisions.reserve(frames.size());
  for (const ShapeFrame& frame : frames) divisions.push_back(divisions_for(frame, edge_length));
  const auto pieces = [&](const EdgeRef& ref) -> std::vector<int>& {
    return divisions[index(data.panels[index(ref.panel)].shape)][index(ref.edge)];
  };
  // Raised to the larger of both sides until nothing changes; each pass settles at least one edge.
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& seam : data.seams) {
      std::vector<int>& a = pieces(seam[0]);
      std::vector<int>& b = pieces(seam[1]);
      const bool opposite = has_panel_on_left(data, seam[0]) == has_panel_on_left(data, seam[1]);
      for (std::size_t k = 0; k < a.size(); ++k) {
        int& other = b[opposite ? b.size() - 1 - k : k];
        changed = changed || a[k] != other;
        a[k] = other = std::max(a[k], other);
      }
    }
  }
  return divisions;
}

void place(const std::vector<Vec2>& coarse, Pattern& pattern) {
  pattern.flat.resize(pattern.panel.size());
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const auto& points = pattern.coarse_points[v];
    const Vec3& weights = pattern.barycentric[v];
    pattern.flat[v] = weights[0] * coarse[index(points[0])] +
                      weights[1] * coarse[index(points[1])] + weights[2] * coarse[index(points[2])];
  }
}

void check_possible(const GarmentTemplate& garment, const Dimensions& dimensions) {
  if (const auto reason = why_impossible(garment.data(), dimensions))
    throw InvalidInput(garment.name() + ": these dimensions make no garment: " + *reason);
}

}  // namespace

Pattern make_pattern(const GarmentTemplate& garment, const Dimensions& dimensions,
                     double edge_length) {
  if (!(edge_length >= kShortestEdge && edge_length <= kLongestEdge))
    throw InvalidInput("edge_length must lie between 0.002 and 0.5 m, is " +
                       std::to_string(edge_length));
  check_possible(garment, dimensions);
  const TemplateData& data = garment.data();
  const std::vector<ShapeFrame> frames = shape_frames(data);
  if (expected_vertices(data, frames, edge_length) > kMostVertices)
    throw InvalidInput("a pattern with edges of " + std::to_string(edge_length) +
                       " m would have more than a million particles; take longer edges");
  const std::vector<Divisions> divisions = divide_alike(data, frames, edge_length);
  std::vector<ShapeMesh> meshes;
  for (std::size_t s = 0; s < frames.size(); ++s)
    meshes.push_back(fine_mesh(frames[s], divisions[s], edge_length));
  Pattern pattern = sew(data, meshes);
  place(coarse_points(garment, dimensions), pattern);
  return pattern;
}

void move_pattern(const GarmentTemplate& garment, const Dimensions& dimensions, Pattern& pattern) {
  check_possible(garment, dimensions);
  const std::vector<Vec2> coarse = coarse_points(garment, dimensions);
  for (const auto& points : pattern.coarse_points)
    for (const int point : points)
      if (point < 0 || point >= static_cast<int>(coarse.size()))
        throw InvalidInput("the pattern was not made from the template " + garment.name());
  place(coarse, pattern);
}

std::vector<Vec2> coarse_points(const GarmentTemplate& garment, const Dimensions& dimensions) {
  const TemplateData& data = garment.data();
  const NameScope scope(data, dimensions);
  std::vector<Vec2> all;
  for (const PanelData& panel : data.panels) {
    const ShapeData& shape = data.shapes[index(panel.shape)];
    const std::vector<Vec2> points = shape_points(shape, scope);
    for (int half = 0; half < (shape.on_fold ? 2 : 1); ++half) {
      const double side = panel.mirrored != (half == 1) ? -1.0 : 1.0;
      for (const Vec2& p : points) all.emplace_back(side * p.x(), p.y());
    }
  }
  return all;
}

const PatternEdge& edge_named(const Pattern& pattern, const std::string& name) {
  for (const PatternEdge& edge : pattern.edges)
    if (edge.name == name) return edge;
  throw InvalidInput("the pattern has no edge '" + name + "'");
}

double loop_length(const Pattern& pattern, const PatternEdge& edge) {
  double length = 0.0;
  for (const auto& segment : edge.segments)
    length += (pattern.flat[index(segment[0])] - pattern.flat[index(segment[1])]).norm();
  return length;
}

}  // namespace regarment
