#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/known_options.h"
#include "base/error.h"
#include "garment/describe_template.h"
#include "garment/find_template.h"
#include "garment/pattern.h"
#include "report/template_json.h"
#include "report/text.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

double cm(double metres) { return rounded(metres * 100.0, 4); }

constexpr double kPatternEdge = 0.025;  // m, as cloth is divided for a fit

Dimensions dimensions_at(const GarmentTemplate& garment, const std::vector<std::string>& texts) {
  Dimensions out = garment.typical();
  for (const NamedLength& one : named_lengths("--at", texts)) {
    const auto place = out.find(one.name);
    if (place == out.end())
      throw UsageError("--at: " + garment.name() + " has no dimension '" + one.name +
                       "'; 'regarment templates " + garment.name() + "' lists them");
    place->second = one.cm / 100;
  }
  return out;
}

Json points_cm(const std::vector<Vec2>& points) {
  Json out = Json::array();
  for (const Vec2& p : points) out.push_back({cm(p.x()), cm(p.y())});
  return out;
}

// The pattern's triangles, and the coarse triangles that carry its points (paper, Fig. 3).
Json pattern_at(const GarmentTemplate& garment, const std::vector<std::string>& texts) {
  const Dimensions dimensions = dimensions_at(garment, texts);
  Pattern pattern;
  try {
    pattern = make_pattern(garment, dimensions, kPatternEdge);
  } catch (const InvalidInput& error) {
    throw UsageError(std::string("--at: ") + error.what());
  }
  return {{"panels", pattern.panel_names},
          {"points_cm", points_cm(pattern.flat)},
          {"panel_of_point", pattern.panel},
          {"triangles", pattern.triangles},
          {"coarse_points_cm", points_cm(coarse_points(garment, dimensions))},
          {"coarse_triangle_of_point", pattern.coarse_points}};
}

std::string list_as_text() {
  std::string text;
  for (const TemplateEntry& entry : list_templates()) {
    std::string name = entry.name;
    name.resize(std::max<std::size_t>(name.size(), 16), ' ');
    text += name + "  " + entry.title + "  (" + entry.source + ")\n";
  }
  return text;
}

}  // namespace

void run_templates(const TemplatesArguments& arguments, Console& console) {
  if (!arguments.at.empty() && !(arguments.name && console.wants_json()))
    throw UsageError("--at: needs the name of a template and --json");
  if (!arguments.name) {
    console.answer(console.wants_json() ? templates_json() : list_as_text());
    return;
  }
  const GarmentTemplate garment = find_template(*arguments.name);
  if (!console.wants_json()) {
    console.answer(describe_template(garment));
    return;
  }
  Json json = Json::parse(template_json(garment));
  if (!arguments.at.empty()) json["pattern"] = pattern_at(garment, arguments.at);
  console.answer(json.dump(2) + "\n");
}

}  // namespace regarment
