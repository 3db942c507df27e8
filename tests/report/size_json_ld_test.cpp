#include "report/size_json_ld.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "results.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

TEST(SizeJsonLd, NamesMeasurementsAsSchemaOrgDoes) {
  const Json document = Json::parse(size_json_ld(example_result()));
  EXPECT_EQ(document["@context"], "https://schema.org");
  const Json& product = document["@graph"][0];
  EXPECT_EQ(product["@type"], "Product");
  EXPECT_EQ(product["size"]["@type"], "SizeSpecification");
  const Json& sizes = product["size"]["hasMeasurement"];
  ASSERT_EQ(sizes.size(), 3u);  // the hip was not seen
  EXPECT_EQ(sizes[2]["valueReference"], "https://schema.org/WearableMeasurementWaist");
  EXPECT_EQ(sizes[2]["value"], 78.4);
  EXPECT_NEAR(sizes[2]["minValue"], 77.2, 1e-9);
  EXPECT_EQ(sizes[2]["unitCode"], "CMT");  // UN/CEFACT: centimetre
}

TEST(SizeJsonLd, AChestIsNoWidth) {
  Result result = example_result();
  result.garments[0].template_name = "tshirt";
  const Json document = Json::parse(size_json_ld(result));
  EXPECT_EQ(document["@graph"][0]["size"]["hasMeasurement"][1]["valueReference"],
            "https://schema.org/WearableMeasurementChestOrBust");
}

TEST(SizeJsonLd, CannotEndItsScriptElement) {
  Result result = example_result();
  result.garments[0].title = "</script><script>alert(1)</script>\xff";
  const std::string text = size_json_ld(result);
  EXPECT_EQ(text.find('<'), std::string::npos);
  const std::string name = Json::parse(text)["@graph"][0]["name"];
  EXPECT_TRUE(name.starts_with("</script>"));
}

}  // namespace
}  // namespace regarment
