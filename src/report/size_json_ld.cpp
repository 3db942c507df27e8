#include "report/size_json_ld.h"

#include <nlohmann/json.hpp>

#include <array>

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

/// schema.org's word for a measurement, by its name; nothing where none fits.
std::string kind_of(const ResultGarment& garment, const ResultMeasurement& m) {
  if (garment.template_name == "tshirt" && m.name == "width") return "ChestOrBust";
  constexpr std::array<std::array<const char*, 2>, 5> kKinds = {{{"length", "Length"},
                                                                 {"width", "Width"},
                                                                 {"waist", "Waist"},
                                                                 {"hip", "Hips"},
                                                                 {"sleeve_length", "Sleeve"}}};
  for (const auto& [name, kind] : kKinds)
    if (m.name == name) return kind;
  return "";
}

Json measurement(const ResultGarment& garment, const ResultMeasurement& m) {
  Json out = {{"@type", "QuantitativeValue"}, {"name", m.title},     {"alternateName", m.code},
              {"description", m.definition},  {"value", m.value_cm}, {"minValue", m.low_cm},
              {"maxValue", m.high_cm},        {"unitCode", "CMT"},   {"unitText", "cm"}};
  const std::string kind = kind_of(garment, m);
  if (!kind.empty()) out["valueReference"] = "https://schema.org/WearableMeasurement" + kind;
  return out;
}

Json product(const ResultGarment& garment) {
  Json measurements = Json::array();
  for (const ResultMeasurement& m : garment.measurements)
    if (m.observable) measurements.push_back(measurement(garment, m));
  return {{"@type", "Product"},
          {"name", garment.title},
          {"category", garment.template_name},
          {"size",
           {{"@type", "SizeSpecification"},
            {"name", "As measured on a scan"},
            {"hasMeasurement", measurements}}}};
}

}  // namespace

std::string size_json_ld(const Result& result) {
  Json products = Json::array();
  for (const ResultGarment& garment : result.garments) products.push_back(product(garment));
  const Json document = {{"@context", "https://schema.org"}, {"@graph", products}};
  std::string text = document.dump(2, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace regarment
