#include "pages/garment_choices.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "garment/find_template.h"
#include "garment/pattern.h"
#include "garment/pattern_svg.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

// Edges that a height can be given for: a neckline has no single one.
Json level_edges(const GarmentTemplate& garment) {
  constexpr double kCoarse = 0.2;  // m: the names are the same at any size
  Json out = Json::array();
  for (const PatternEdge& edge : make_pattern(garment, garment.typical(), kCoarse).edges)
    if (edge.limb != "neck") out.push_back({{"name", edge.name}, {"limb", edge.limb}});
  return out;
}

}  // namespace

std::string garment_choices_json() {
  Json out = Json::array();
  for (const TemplateEntry& entry : list_templates()) {
    try {
      out.push_back({{"name", entry.name},
                     {"title", entry.title},
                     {"edges", level_edges(find_template(entry.name))},
                     {"sketch", "/pages/garment-" + entry.name + ".svg"}});
    } catch (const Error&) {
      // A folder of templates may hold one that is broken; asking for it by name says why.
      continue;
    }
  }
  return out.dump(2) + "\n";
}

std::optional<std::string> garment_sketch(const std::string& name) {
  const std::vector<TemplateEntry> known = list_templates();
  if (std::none_of(known.begin(), known.end(),
                   [&](const TemplateEntry& entry) { return entry.name == name; }))
    return std::nullopt;
  const GarmentTemplate garment = find_template(name);
  PatternDrawingOptions options;
  options.style = PatternStyle::Sketch;
  return pattern_svg(garment, garment.typical(), options);
}

}  // namespace regarment
