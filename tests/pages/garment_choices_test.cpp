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

// What `--hint` takes: a skirt has its waist and hem round the trunk, a T-shirt its hem alone,
// since its cuffs lie round the arms and its neckline slants.
TEST(GarmentChoices, OfferTheEdgesRoundTheTrunk) {
  const auto edges = [](const std::string& name) {
    auto out = choice(name)["edges"].get<std::vector<std::string>>();
    std::sort(out.begin(), out.end());
    return out;
  };
  EXPECT_EQ(edges("skirt"), (std::vector<std::string>{"hem", "waist"}));
  EXPECT_EQ(edges("tshirt"), (std::vector<std::string>{"hem"}));
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
