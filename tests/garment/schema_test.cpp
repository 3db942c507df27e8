#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace regarment {
namespace {

using Json = nlohmann::json;

Json read_json(const std::string& name) {
  std::ifstream stream(std::filesystem::path(TEMPLATE_FOLDER) / name);
  return Json::parse(stream);
}

bool fits_schema(const Json& document) {
  const Json schema_json = read_json("garment-template.schema.json");
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json), schema);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

TEST(TemplateSchema, AcceptsTheTemplatesThatComeWithTheProgram) {
  EXPECT_TRUE(fits_schema(read_json("skirt.json")));
  EXPECT_TRUE(fits_schema(read_json("tshirt.json")));
}

TEST(TemplateSchema, RefusesAnythingMissingMisspeltOrOfTheWrongKind) {
  const Json good = read_json("tshirt.json");
  for (const auto& [key, unused] : good.items()) {
    Json bad = good;
    bad.erase(key);
    EXPECT_FALSE(fits_schema(bad)) << "without " << key;
  }
  const std::vector<std::pair<std::string, Json>> changes = {
      {"/colour", "red"},
      {"/format", "regarment.template/2"},
      {"/name", "T-shirt"},
      {"/dimensions", Json::array()},
      {"/dimensions/0/lower", "22"},
      {"/dimensions/0/lower", -1},
      {"/dimensions/0/colour", "red"},
      {"/constants/neck_drop", "7"},
      {"/pattern/panels/front/face", "side"},
      {"/pattern/panels/front/limb", "tail"},
      {"/pattern/panels/front/vertices/0", Json::array({"0"})},
      {"/pattern/panels/front/edges/0/curvature/type", "spline"},
      {"/pattern/panels/back/mirror_of", "front"},
      {"/pattern/stitches/0/0/edge", 3},
      {"/observations/0/kind", "guess"},
      {"/drawing/measures/0/share", 2},
  };
  for (const auto& [pointer, value] : changes) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    EXPECT_FALSE(fits_schema(bad)) << pointer;
  }
}

}  // namespace
}  // namespace regarment
