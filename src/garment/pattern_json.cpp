#include "garment/pattern_json.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "garment/panel_outline.h"
#include "garment/template_check.h"

namespace regarment {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kCm = 100.0;          // per metre
constexpr double kGapFromBody = 25.0;  // cm, front panels before, back panels behind the body

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// To a billionth, so that a whole number of centimetres is written as one.
double tidy(double value) {
  const double rounded = std::round(value * 1e9) / 1e9;
  return rounded == 0.0 ? 0.0 : rounded;  // no minus zero
}

Json point(const Vec2& p) { return {tidy(p.x()), tidy(p.y())}; }

/// GarmentCode's panels have y pointing up.
Vec2 in_cm(const Vec2& flat) { return {kCm * flat.x(), -kCm * flat.y()}; }

Json curvature(const OutlineEdge& edge) {
  const Vec2 a = in_cm(edge.points.front()), along = in_cm(edge.points.back()) - a;
  const Vec2 across(-along.y(), along.x());
  Json params = Json::array();
  for (const Vec2& control : edge.controls) {
    const Vec2 offset = in_cm(control) - a;
    params.push_back(point(Vec2(offset.dot(along), offset.dot(across)) / along.squaredNorm()));
  }
  return {{"type", edge.controls.size() == 1 ? "quadratic" : "cubic"}, {"params", params}};
}

Json panel(const std::vector<OutlineEdge>& outline, bool is_front) {
  Json vertices = Json::array(), edges = Json::array();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    vertices.push_back(point(in_cm(outline[i].points.front())));
    Json edge = {{"endpoints", {i, (i + 1) % outline.size()}}};
    if (!outline[i].controls.empty()) edge["curvature"] = curvature(outline[i]);
    if (outline[i].is_free) edge["label"] = outline[i].name;
    edges.push_back(std::move(edge));
  }
  return {{"translation", {0.0, 0.0, is_front ? kGapFromBody : -kGapFromBody}},
          {"rotation", {0.0, 0.0, 0.0}},
          {"vertices", vertices},
          {"edges", edges}};
}

Json stitch_side(const TemplateData& data, const std::vector<std::vector<OutlineEdge>>& outlines,
                 const EdgeRef& ref) {
  const auto& outline = outlines[index(ref.panel)];
  const auto edge = std::find_if(outline.begin(), outline.end(),
                                 [&](const OutlineEdge& e) { return e.ref == ref; });
  return {{"panel", data.panels[index(ref.panel)].name}, {"edge", edge - outline.begin()}};
}

Json parameters(const GarmentTemplate& garment, const Dimensions& dimensions) {
  Json all = Json::object();
  for (const Dimension& d : garment.dimensions())
    all[d.name] = {{"type", "additive_length"},
                   {"code", d.code},
                   {"value", tidy(kCm * dimensions.at(d.name))},
                   {"range", {tidy(kCm * d.lower), tidy(kCm * d.upper)}},
                   {"influence", Json::array()}};
  return all;
}

}  // namespace

std::string pattern_json(const GarmentTemplate& garment, const Dimensions& dimensions) {
  const TemplateData& data = garment.data();
  const NameScope scope(data, dimensions);
  if (const auto reason = why_impossible(data, dimensions))
    throw InvalidInput(garment.name() + ": these dimensions make no garment: " + *reason);
  std::vector<std::vector<OutlineEdge>> outlines;
  Json panels = Json::object(), order = Json::array(), stitches = Json::array();
  for (int p = 0; p < static_cast<int>(data.panels.size()); ++p) {
    outlines.push_back(panel_outline(data, p, scope));
    panels[data.panels[index(p)].name] = panel(outlines.back(), data.panels[index(p)].is_front);
    order.push_back(data.panels[index(p)].name);
  }
  for (const auto& seam : data.seams)
    stitches.push_back(
        {stitch_side(data, outlines, seam[0]), stitch_side(data, outlines, seam[1])});
  Json parameter_order = Json::array();
  for (const Dimension& d : garment.dimensions()) parameter_order.push_back(d.name);
  const Json document = {
      {"pattern", {{"panels", panels}, {"stitches", stitches}, {"panel_order", order}}},
      {"parameters", parameters(garment, dimensions)},
      {"parameter_order", parameter_order},
      {"properties",
       {{"curvature_coords", "relative"},
        {"normalize_panel_translation", false},
        {"normalized_edge_loops", true},
        {"units_in_meter", 100}}}};
  return document.dump(2) + "\n";
}

}  // namespace regarment
