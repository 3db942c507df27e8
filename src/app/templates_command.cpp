#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "garment/describe_template.h"
#include "garment/find_template.h"
#include "report/text.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

double cm(double metres) { return rounded(metres * 100.0, 4); }

Json template_json(const GarmentTemplate& garment) {
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
  return {{"name", garment.name()},
          {"title", garment.title()},
          {"description", garment.description()},
          {"dimensions", dimensions},
          {"sources", garment.sources()}};
}

std::string list_as_json() {
  Json list = Json::array();
  for (const TemplateEntry& entry : list_templates()) {
    list.push_back({{"name", entry.name}, {"title", entry.title}, {"source", entry.source}});
  }
  return list.dump(2) + "\n";
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
  if (!arguments.name) {
    console.answer(console.wants_json() ? list_as_json() : list_as_text());
    return;
  }
  const GarmentTemplate garment = find_template(*arguments.name);
  console.answer(console.wants_json() ? template_json(garment).dump(2) + "\n"
                                      : describe_template(garment));
}

}  // namespace regarment
