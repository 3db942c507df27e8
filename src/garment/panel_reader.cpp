#include "garment/panel_reader.h"

#include <algorithm>
#include <set>

#include "base/error.h"

namespace regarment {

namespace {

constexpr std::size_t kMaxPanels = 32;
constexpr std::size_t kMaxVertices = 64;
constexpr int kMaxSegments = 32;

bool is_known(const TemplateData& data, const std::string& name) {
  const auto named = [&](const auto& thing) { return thing.name == name; };
  return std::any_of(data.dimensions.begin(), data.dimensions.end(), named) ||
         std::any_of(data.derived.begin(), data.derived.end(), named) ||
         std::any_of(data.constants.begin(), data.constants.end(),
                     [&](const auto& constant) { return constant.first == name; });
}

std::vector<std::array<Formula, 2>> read_points(const JsonNode& node, std::size_t fewest,
                                                const TemplateData& data) {
  std::vector<std::array<Formula, 2>> points;
  for (const JsonNode& point : node.items(fewest, kMaxVertices))
    points.push_back(read_point(point, data));
  return points;
}

Curvature read_curvature(const JsonNode& node, const TemplateData& data) {
  node.keys({"type", "params", "segments"});
  Curvature curvature;
  const std::string type = node.at("type").text();
  std::size_t params = 1;
  if (type == "quadratic") {
    curvature.kind = Curvature::Kind::Quadratic;
  } else if (type == "cubic") {
    curvature.kind = Curvature::Kind::Cubic;
    params = 2;
  } else if (type != "ellipse") {
    node.at("type").fail("must be 'quadratic', 'cubic' or 'ellipse'");
  }
  for (const JsonNode& param : node.at("params").items(params, params))
    curvature.params.push_back(read_point(param, data));
  curvature.segments = node.at("segments").integer(2, kMaxSegments);
  return curvature;
}

std::array<int, 2> read_endpoints(const JsonNode& node, std::size_t points) {
  const auto ends = node.items(2, 2);
  const int last = static_cast<int>(points) - 1;
  const std::array<int, 2> pair = {ends[0].integer(0, last), ends[1].integer(0, last)};
  if (pair[0] == pair[1]) node.fail("joins a point with itself");
  return pair;
}

/// The edges must run round the panel, each starting where the one before ends.
void check_chain(const JsonNode& node, const ShapeData& shape) {
  const auto edges = node.at("edges").items(1, kMaxVertices);
  const std::size_t n = shape.edges.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (shape.edges[i].to != shape.edges[i + 1].from)
      edges[i + 1]
          .at("endpoints")
          .fail("the panel is not closed: the edge must start at vertex " +
                std::to_string(shape.edges[i].to) + ", where the edge before it ends");
  }
  const bool closed = shape.edges.back().to == shape.edges.front().from;
  if (!shape.on_fold && !closed) {
    edges[n - 1]
        .at("endpoints")
        .fail("the panel is not closed: the last edge must end at vertex " +
              std::to_string(shape.edges.front().from));
  }
  if (n != shape.vertices.size() - (shape.on_fold ? 1 : 0) || (shape.on_fold && closed))
    node.at("edges").fail("must pass every vertex exactly once");
  for (const int end : {shape.edges.front().from, shape.edges.back().to}) {
    if (shape.on_fold && !shape.vertices[static_cast<std::size_t>(end)][0].is_zero_constant()) {
      node.at("vertices")
          .fail("a panel cut on the fold begins and ends on the fold: vertex " +
                std::to_string(end) + " must have \"0\" as first coordinate");
    }
  }
}

ShapeData read_shape(const JsonNode& node, const std::string& panel, const TemplateData& data) {
  node.keys({"limb", "face", "cut_on_fold", "vertices", "edges", "points", "lines"});
  ShapeData shape;
  shape.panel = panel;
  shape.on_fold = node.has("cut_on_fold") && node.at("cut_on_fold").boolean();
  shape.vertices = read_points(node.at("vertices"), 3, data);
  for (const JsonNode& edge : node.at("edges").items(2, kMaxVertices)) {
    edge.keys({"name", "endpoints", "curvature"});
    const auto ends = read_endpoints(edge.at("endpoints"), shape.vertices.size());
    shape.edges.push_back({edge.at("name").name(), ends[0], ends[1], std::nullopt});
    if (edge.has("curvature"))
      shape.edges.back().curvature = read_curvature(edge.at("curvature"), data);
  }
  check_chain(node, shape);
  if (node.has("points")) shape.points = read_points(node.at("points"), 0, data);
  if (node.has("lines")) {
    for (const JsonNode& line : node.at("lines").items(0, kMaxVertices)) {
      line.keys({"title", "endpoints"});
      const auto ends =
          read_endpoints(line.at("endpoints"), shape.vertices.size() + shape.points.size());
      const std::string title = line.has("title") ? line.at("title").text(60) : std::string();
      shape.lines.push_back({title, ends[0], ends[1]});
    }
  }
  return shape;
}

bool read_is_front(const JsonNode& node) {
  const std::string face = node.text();
  if (face != "front" && face != "back") node.fail("must be 'front' or 'back'");
  return face == "front";
}

/// A panel that repeats an earlier one, as it is or mirrored.
PanelData read_repeat(const JsonNode& node, const char* key, const TemplateData& data) {
  node.keys({"limb", "face", key});
  const std::string original = node.at(key).text(40);
  for (const PanelData& panel : data.panels) {
    if (panel.name != original) continue;
    PanelData repeat = panel;
    if (std::string(key) == "mirror_of") repeat.mirrored = !repeat.mirrored;
    return repeat;
  }
  node.at(key).fail("names no panel that stands before it in panel_order");
}

void read_panel(const JsonNode& node, const std::string& name, TemplateData& data) {
  PanelData panel;
  if (node.has("copy_of")) {
    panel = read_repeat(node, "copy_of", data);
  } else if (node.has("mirror_of")) {
    panel = read_repeat(node, "mirror_of", data);
  } else {
    panel.shape = static_cast<int>(data.shapes.size());
    data.shapes.push_back(read_shape(node, name, data));
  }
  panel.name = name;
  panel.limb = read_limb(node.at("limb"));
  panel.is_front = read_is_front(node.at("face"));
  data.panels.push_back(panel);
}

std::vector<EdgeRef> all_edges(const TemplateData& data) {
  std::vector<EdgeRef> refs;
  for (int p = 0; p < static_cast<int>(data.panels.size()); ++p) {
    const PanelData& panel = data.panels[static_cast<std::size_t>(p)];
    const ShapeData& shape = data.shapes[static_cast<std::size_t>(panel.shape)];
    for (int half = 0; half < (shape.on_fold ? 2 : 1); ++half)
      for (int e = 0; e < static_cast<int>(shape.edges.size()); ++e) refs.push_back({p, half, e});
  }
  return refs;
}

EdgeRef read_edge_ref(const JsonNode& node, const std::vector<EdgeRef>& all,
                      const TemplateData& data) {
  node.keys({"panel", "edge"});
  const std::string panel = node.at("panel").text(40);
  const std::string edge = node.at("edge").text(40);
  std::vector<EdgeRef> matches;
  bool panel_known = false;
  for (const EdgeRef& ref : all) {
    if (data.panels[static_cast<std::size_t>(ref.panel)].name != panel) continue;
    panel_known = true;
    if (edge_name(data, ref) == edge) matches.push_back(ref);
  }
  if (!panel_known) node.at("panel").fail("there is no panel of this name");
  if (matches.empty()) node.at("edge").fail("panel '" + panel + "' has no edge of this name");
  if (matches.size() > 1)
    node.at("edge").fail("panel '" + panel + "' has several edges of this name; a seam needs one");
  return matches[0];
}

std::string describe(const TemplateData& data, const EdgeRef& ref) {
  return "edge '" + edge_name(data, ref) + "' of panel '" +
         data.panels[static_cast<std::size_t>(ref.panel)].name + "'";
}

void read_stitches(const JsonNode& node, TemplateData& data, std::set<EdgeRef>& sewn) {
  const std::vector<EdgeRef> all = all_edges(data);
  for (const JsonNode& stitch : node.items(0, 256)) {
    const auto sides = stitch.items(2, 2);
    const std::array<EdgeRef, 2> seam = {read_edge_ref(sides[0], all, data),
                                         read_edge_ref(sides[1], all, data)};
    for (const EdgeRef& side : seam)
      if (!sewn.insert(side).second) stitch.fail(describe(data, side) + " is sewn twice");
    data.seams.push_back(seam);
  }
}

}  // namespace

std::string read_limb(const JsonNode& node) {
  static const std::set<std::string> kLimbs = {"torso",     "neck",     "left_arm",
                                               "right_arm", "left_leg", "right_leg"};
  std::string limb = node.text();
  if (!kLimbs.contains(limb))
    node.fail("must be torso, neck, left_arm, right_arm, left_leg or right_leg");
  return limb;
}

Formula read_formula(const JsonNode& node, const TemplateData& data) {
  if (node.is_number()) return Formula(node.number(-1e6, 1e6));
  const std::string text = node.text(Formula::kMaxLength + 1);
  try {
    Formula formula = Formula::parse(text);
    for (const std::string& name : formula.names())
      if (!is_known(data, name)) {
        node.fail("formula '" + text + "': '" + name +
                  "' is no dimension, constant or earlier derived name");
      }
    return formula;
  } catch (const InvalidInput& error) {
    node.fail(error.what());
  }
}

std::array<Formula, 2> read_point(const JsonNode& node, const TemplateData& data) {
  const auto coordinates = node.items(2, 2);
  return {read_formula(coordinates[0], data), read_formula(coordinates[1], data)};
}

void read_pattern(const JsonNode& pattern, const JsonNode& free_edges, TemplateData& data) {
  pattern.keys({"panels", "panel_order", "stitches"});
  const JsonNode panels = pattern.at("panels");
  std::set<std::string> seen;
  for (const JsonNode& entry : pattern.at("panel_order").items(1, kMaxPanels)) {
    const std::string name = entry.name();
    if (!seen.insert(name).second) entry.fail("the panel stands twice in panel_order");
    read_panel(panels.at(name), name, data);
  }
  for (const std::string& name : panels.member_names(kMaxPanels))
    if (!seen.contains(name)) panels.at(name).fail("the panel is missing in panel_order");

  std::set<EdgeRef> sewn;
  read_stitches(pattern.at("stitches"), data, sewn);
  for (const std::string& name : free_edges.member_names(32)) {
    const JsonNode node = free_edges.at(name);
    node.keys({"limb"});
    data.free_edges.push_back({name, read_limb(node.at("limb")), {}});
  }
  for (const EdgeRef& ref : all_edges(data)) {
    if (sewn.contains(ref)) continue;
    const std::string name = edge_name(data, ref);
    const auto edge = std::find_if(data.free_edges.begin(), data.free_edges.end(),
                                   [&](const FreeEdge& free) { return free.name == name; });
    if (edge == data.free_edges.end())
      pattern.at("stitches").fail(describe(data, ref) + " is neither sewn nor a free edge");
    edge->parts.push_back(ref);
  }
  for (const FreeEdge& edge : data.free_edges)
    if (edge.parts.empty())
      free_edges.at(edge.name).fail("no panel has an unsewn edge of this name");
}

}  // namespace regarment
