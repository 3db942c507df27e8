#include "report/template_json.h"

#include <nlohmann/json.hpp>

#include "garment/find_template.h"
#include "report/text.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

double cm(double metres) { return rounded(metres * 100.0, 4); }

}  // namespace

std::string templates_json() {
  Json list = Json::array();
  for (const TemplateEntry& entry : list_templates()) {
    list.push_back({{"name", entry.name}, {"title", entry.title}, {"source", entry.source}});
  }
  return list.dump(2) + "\n";
}

std::string template_json(const GarmentTemplate& garment) {
  Json dimensions = Json::array();
  for (const Dimension& d : garment.dimensions()) {
    dimensions.push_back({{"name", d.name},
                          {"code", d.code},
                          {"title", d.title},
                          {"definition", d.definition},
                          {"how_to_measure", d.how_to_measure},
                          {"circumference", d.circumference},
                          {"typical_cm", cm(d.typical)},
                          {"bounds_cm", {cm(d.lower), cm(d.upper)}}});
  }
  const Json json = {{"name", garment.name()},
                     {"title", garment.title()},
                     {"description", garment.description()},
                     {"dimensions", dimensions},
                     {"sources", garment.sources()}};
  return json.dump(2) + "\n";
}

}  // namespace regarment
