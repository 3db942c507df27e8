#include "garment/template_reader.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "garment/json_node.h"
#include "garment/panel_reader.h"

namespace regarment {

namespace {

constexpr std::size_t kMaxDimensions = 12;

/// Names that would hide a constant or a function of the formula language.
void claim_name(const JsonNode& node, const std::string& name, std::set<std::string>& taken) {
  static const std::set<std::string> kReserved = {"pi",    "min", "max", "sqrt", "abs",    "pow",
                                                  "hypot", "sin", "cos", "tan",  "degrees"};
  if (kReserved.contains(name))
    node.fail("the name '" + name + "' belongs to the formula language");
  if (!taken.insert(name).second) node.fail("the name '" + name + "' is already taken");
}

Dimension read_dimension(const JsonNode& node, double units_in_meter) {
  node.keys({"name", "code", "title", "definition", "how_to_measure", "circumference", "lower",
             "upper", "typical"});
  Dimension dimension;
  dimension.name = node.at("name").name();
  dimension.code = node.at("code").text(8);
  dimension.title = node.at("title").text(60);
  dimension.definition = node.at("definition").text();
  dimension.how_to_measure = node.at("how_to_measure").text();
  dimension.circumference = node.at("circumference").boolean();
  const double shortest = 0.001 * units_in_meter, longest = 10.0 * units_in_meter;
  const double lower = node.at("lower").number(shortest, longest);
  const double upper = node.at("upper").number(shortest, longest);
  if (!(lower < upper)) node.at("upper").fail("must be larger than 'lower'");
  dimension.typical = node.at("typical").number(lower, upper) / units_in_meter;
  dimension.lower = lower / units_in_meter;
  dimension.upper = upper / units_in_meter;
  return dimension;
}

void read_dimensions(const JsonNode& root, TemplateData& data, std::set<std::string>& taken) {
  std::set<std::string> codes;
  for (const JsonNode& node : root.at("dimensions").items(1, kMaxDimensions)) {
    data.dimensions.push_back(read_dimension(node, data.units_in_meter));
    claim_name(node.at("name"), data.dimensions.back().name, taken);
    if (!codes.insert(data.dimensions.back().code).second)
      node.at("code").fail("the code is already taken");
  }
}

void read_names(const JsonNode& root, TemplateData& data, std::set<std::string>& taken) {
  const JsonNode constants = root.at("constants");
  for (const std::string& name : constants.member_names(64)) {
    const JsonNode node = constants.at(name);
    claim_name(node, name, taken);
    data.constants.emplace_back(name, node.number(-1e6, 1e6));
  }
  for (const JsonNode& node : root.at("derived").items(0, 64)) {
    node.keys({"name", "formula"});
    const std::string name = node.at("name").name();
    const Formula formula = read_formula(node.at("formula"), data);
    claim_name(node.at("name"), name, taken);
    data.derived.push_back({name, formula});
  }
  for (const JsonNode& node : root.at("requires").items(0, 32)) {
    node.keys({"positive", "message"});
    data.requirements.push_back(
        {read_formula(node.at("positive"), data), node.at("message").text(300)});
  }
}

std::string read_free_edge(const JsonNode& node, const TemplateData& data) {
  std::string name = node.text(40);
  for (const FreeEdge& edge : data.free_edges)
    if (edge.name == name) return name;
  node.fail("there is no free edge of this name");
}

Observation read_observation(const JsonNode& node, const TemplateData& data) {
  node.keys({"name", "kind", "edge", "to_edge", "side", "offset", "equals"});
  Observation observation;
  observation.name = node.at("name").text(60);
  const std::string kind = node.at("kind").text(40);
  observation.edge = read_free_edge(node.at("edge"), data);
  if (kind == "girth") {
    observation.kind = Observation::Kind::Girth;
  } else if (kind == "girth_at_offset") {
    observation.kind = Observation::Kind::GirthAtOffset;
    observation.offset =
        node.at("offset").number(0.0, 2.0 * data.units_in_meter) / data.units_in_meter;
  } else if (kind == "path") {
    observation.kind = Observation::Kind::Path;
    observation.to_edge = read_free_edge(node.at("to_edge"), data);
  } else if (kind == "fork") {
    observation.kind = Observation::Kind::Fork;
  } else {
    node.at("kind").fail("must be 'girth', 'girth_at_offset', 'path' or 'fork'");
  }
  if (node.has("side")) {
    static const std::set<std::string> kSides = {"centre", "top", "shoulder_point", "underarm"};
    observation.side = node.at("side").text(40);
    if (!kSides.contains(observation.side))
      node.at("side").fail("must be 'centre', 'top', 'shoulder_point' or 'underarm'");
  }
  observation.equals = read_formula(node.at("equals"), data).text();
  return observation;
}

MeasureArrow read_arrow(const JsonNode& node, const TemplateData& data) {
  node.keys({"dimension", "piece", "share", "from", "to", "offset", "label_at"});
  MeasureArrow arrow;
  arrow.dimension = node.at("dimension").text(40);
  if (std::none_of(data.dimensions.begin(), data.dimensions.end(),
                   [&](const Dimension& d) { return d.name == arrow.dimension; }))
    node.at("dimension").fail("there is no dimension of this name");
  arrow.piece =
      node.has("piece") ? node.at("piece").integer(0, static_cast<int>(data.pieces.size()) - 1) : 0;
  if (node.has("label_at")) arrow.label_at = node.at("label_at").number(0.0, 1.0);
  arrow.share = node.at("share").number(0.01, 1.0);
  arrow.from = read_point(node.at("from"), data);
  arrow.to = read_point(node.at("to"), data);
  arrow.offset = read_formula(node.at("offset"), data);
  return arrow;
}

void read_drawing(const JsonNode& node, TemplateData& data) {
  node.keys({"pieces", "measures"});
  for (const JsonNode& entry : node.at("pieces").items(1, 16)) {
    entry.keys({"title", "panels", "cut", "grain"});
    DrawnPiece piece;
    piece.title = entry.at("title").text(80);
    piece.cut = entry.at("cut").integer(1, 99);
    const auto grain = entry.at("grain").items(2, 2);
    piece.grain_from = read_point(grain[0], data);
    piece.grain_to = read_point(grain[1], data);
    for (const JsonNode& panel : entry.at("panels").items(1, data.panels.size())) {
      const std::string name = panel.text(40);
      const auto found = std::find_if(data.panels.begin(), data.panels.end(),
                                      [&](const PanelData& p) { return p.name == name; });
      if (found == data.panels.end()) panel.fail("there is no panel of this name");
      piece.panels.push_back(static_cast<int>(found - data.panels.begin()));
    }
    data.pieces.push_back(std::move(piece));
  }
  for (const JsonNode& entry : node.at("measures").items(0, 32))
    data.arrows.push_back(read_arrow(entry, data));
}

}  // namespace

TemplateData read_template(const std::string& json, const std::string& file) {
  const nlohmann::json document = parse_template_json(json, file);
  const JsonNode root(document, "", file);
  root.keys({"format", "name", "title", "description", "sources", "properties", "dimensions",
             "constants", "derived", "requires", "pattern", "free_edges", "observations",
             "drawing"});
  if (root.at("format").text() != "regarment.template/1")
    root.at("format").fail("must be 'regarment.template/1'");
  TemplateData data;
  data.file = file;
  data.name = root.at("name").name();
  data.title = root.at("title").text(60);
  data.description = root.at("description").text();
  for (const JsonNode& source : root.at("sources").items(0, 16))
    data.sources.push_back(source.text(1000));
  const JsonNode properties = root.at("properties");
  properties.keys({"units_in_meter", "curvature_coords"});
  data.units_in_meter = properties.at("units_in_meter").number(1.0, 1000.0);
  if (properties.at("curvature_coords").text() != "relative")
    properties.at("curvature_coords").fail("must be 'relative'");

  std::set<std::string> taken;
  read_dimensions(root, data, taken);
  read_names(root, data, taken);
  read_pattern(root.at("pattern"), root.at("free_edges"), data);
  for (const JsonNode& node : root.at("observations").items(0, 32))
    data.observations.push_back(read_observation(node, data));
  read_drawing(root.at("drawing"), data);
  return data;
}

}  // namespace regarment
