#include "pages/garment_choices.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "garment/find_template.h"
#include "pages/service_page.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

Json choice(const std::string& name) {
  for (const Json& one : Json::parse(garment_choices_json()))
    if (one["name"] == name) return one;
  return {};
}

TEST(GarmentChoices, AreAllTemplates) {
  const Json choices = Json::parse(garment_choices_json());
  const std::vector<TemplateEntry> known = list_templates();
  ASSERT_EQ(choices.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_EQ(choices[i]["name"], known[i].name);
    EXPECT_EQ(choices[i]["title"], known[i].title);
  }
}

// What `--hint` takes: a skirt has its waist and hem round the trunk, a T-shirt its hem there and
// its cuffs round the arms; its neckline slants.
TEST(GarmentChoices, OfferTheEdgesThatHaveAHeight) {
  const auto edges = [](const std::string& name) {
    std::map<std::string, std::string> out;
    const Json garment = choice(name);
    for (const Json& edge : garment["edges"]) out[edge["name"]] = edge["limb"];
    return out;
  };
  using Limbs = std::map<std::string, std::string>;
  EXPECT_EQ(edges("skirt"), (Limbs{{"hem", "torso"}, {"waist", "torso"}}));
  EXPECT_EQ(edges("tshirt"),
            (Limbs{{"hem", "torso"}, {"left_cuff", "left_arm"}, {"right_cuff", "right_arm"}}));
}

TEST(GarmentChoices, HaveADrawingAtTheAddressTheyName) {
  for (const Json& one : Json::parse(garment_choices_json())) {
    const auto sketch = one["sketch"].get<std::string>();
    ASSERT_TRUE(sketch.starts_with("/pages/"));
    const auto page = service_page({"pages", sketch.substr(7)});
    ASSERT_TRUE(page) << sketch;
    EXPECT_EQ(page->content_type, "image/svg+xml");
    EXPECT_NE(page->text.find("<svg"), std::string::npos);
    EXPECT_EQ(page->text.find("<script"), std::string::npos);
    EXPECT_NE(page->policy.find("sandbox"), std::string::npos);
  }
}

TEST(GarmentSketch, OfNoTemplateIsNone) {
  EXPECT_FALSE(garment_sketch("trousers"));
  EXPECT_FALSE(garment_sketch(""));
  EXPECT_FALSE(garment_sketch("/etc/passwd"));
}

}  // namespace
}  // namespace regarment
