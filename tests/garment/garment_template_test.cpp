#include "garment/garment_template.h"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "garment/describe_template.h"
#include "garment/find_template.h"
#include "garment_samples.h"
#include "support/texts.h"

namespace regarment {
namespace {

std::string message_of(const GarmentTemplate& garment, const Dimensions& dimensions) {
  return refusal_of<UsageError>([&] { garment.check(dimensions); });
}

Dimensions with(Dimensions dimensions, const std::string& name, double value) {
  dimensions[name] = value;
  return dimensions;
}

TEST(GarmentTemplate, NamesItsMeasurements) {
  using Row = std::pair<std::string, std::string>;
  const auto codes = [](const GarmentTemplate& garment) {
    std::vector<Row> rows;
    for (const Dimension& d : garment.dimensions()) rows.emplace_back(d.name, d.code);
    return rows;
  };
  EXPECT_EQ(
      codes(find_template("skirt")),
      (std::vector<Row>{{"length", "S01"}, {"width", "S02"}, {"waist", "S03"}, {"hip", "S04"}}));
  EXPECT_EQ(codes(find_template("tshirt")), (std::vector<Row>{{"length", "T01"},
                                                              {"width", "T02"},
                                                              {"sleeve_length", "T03"},
                                                              {"sleeve_opening", "T04"},
                                                              {"sleeve_seam", "T05"}}));
}

TEST(GarmentTemplate, AcceptsItsTypicalDimensions) {
  for (const std::string name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    EXPECT_EQ(message_of(garment, garment.typical()), "") << name;
  }
}

TEST(GarmentTemplate, KnowsWhichDimensionALengthGives) {
  const GarmentTemplate skirt = find_template("skirt");
  EXPECT_TRUE(skirt.gives("hip", "hip", skirt.typical()));
  EXPECT_FALSE(skirt.gives("hip", "waist", skirt.typical()));
  EXPECT_TRUE(skirt.gives("0.6 * hip + 0.4 * waist", "hip", skirt.typical()));
  EXPECT_FALSE(skirt.gives("0.6 * hip + 0.4 * waist", "waist", skirt.typical()));
}

TEST(GarmentTemplate, RefusesWhatIsOutOfBoundsInCentimetres) {
  const GarmentTemplate skirt = find_template("skirt");
  EXPECT_EQ(message_of(skirt, with(skirt.typical(), "waist", 0.399)),
            "skirt: waist 39.9 cm is out of bounds, 40.0 to 180.0 cm");
  EXPECT_EQ(message_of(skirt, with(skirt.typical(), "waist", 0.40)), "");
  EXPECT_NE(message_of(skirt, with(skirt.typical(), "waist", std::nan(""))), "");
  EXPECT_EQ(message_of(skirt, with(skirt.typical(), "collar", 0.4)),
            "skirt has no dimension 'collar'");
  EXPECT_EQ(message_of(skirt, {{"length", 0.6}, {"width", 1.0}, {"waist", 0.8}}),
            "skirt: no value for 'hip'");
}

TEST(GarmentTemplate, SaysWhichCombinationMakesNoGarment) {
  const GarmentTemplate shirt = find_template("tshirt");
  // A body of 190 cm reaches 24 cm out beyond the shoulder point at 23.5 cm; half a seam is 20.
  Dimensions wide = with(with(shirt.typical(), "width", 1.9), "sleeve_seam", 0.4);
  EXPECT_NE(message_of(shirt, wide).find("half the sleeve seam must be at least 1 cm longer"),
            std::string::npos);
  EXPECT_NE(message_of(shirt, wide).find("width 190.0 cm, sleeve_seam 40.0 cm"), std::string::npos);
  Dimensions cropped = with(shirt.typical(), "length", 0.29);
  EXPECT_NE(message_of(shirt, cropped).find("below the underarm"), std::string::npos);
}

TEST(GarmentTemplate, AcceptsShortWideSleeves) {
  // The sleeve's lower corner would lie inside the body; such T-shirts are sold all the same.
  const GarmentTemplate shirt = find_template("tshirt");
  const Dimensions short_wide = {{"length", 0.76},
                                 {"width", 1.25},
                                 {"sleeve_length", 0.17},
                                 {"sleeve_opening", 0.42},
                                 {"sleeve_seam", 0.50}};
  EXPECT_TRUE(test::ShirtPoints(short_wide).is_turned);
  EXPECT_EQ(message_of(shirt, short_wide), "");
}

TEST(GarmentTemplate, AcceptsTheGarmentsOfTheTestScans) {
  const char* shared = std::getenv("REGARMENT_SHARED");
  const std::filesystem::path folder =
      shared ? std::filesystem::path(shared)
             : std::filesystem::path(TEMPLATE_FOLDER) / "../../shared";
  std::ifstream stream(folder / "scans/truth/truth.json");
  if (!stream) GTEST_SKIP() << "no test scans; set REGARMENT_SHARED to the folder that has scans/";
  for (const nlohmann::json& scan : nlohmann::json::parse(stream))
    for (const nlohmann::json& worn : scan.at("garments")) {
      const GarmentTemplate garment = find_template(worn.at("template").get<std::string>());
      Dimensions dimensions;
      for (const auto& [name, value] : worn.at("measurements_cm").items())
        dimensions[name] = value.get<double>() / 100.0;
      EXPECT_EQ(message_of(garment, dimensions), "") << scan.at("name");
    }
}

TEST(GarmentTemplate, EvaluatesObservationsFromDimensions) {
  const GarmentTemplate shirt = find_template("tshirt");
  for (const Dimensions& d : test::possible_dimensions(shirt, 50)) {
    const test::ShirtPoints points(d);
    const double shoulder = (points.shoulder - points.neck).norm();
    for (const Observation& observation : shirt.observations()) {
      const double value = shirt.evaluate(observation.equals, d);
      if (observation.side == "top") {
        EXPECT_NEAR(value, shoulder + d.at("sleeve_length"), 1e-12);
      } else if (observation.kind == Observation::Kind::Fork) {
        EXPECT_NEAR(value, d.at("sleeve_seam"), 1e-12);
      }
    }
  }
  EXPECT_THROW(shirt.evaluate("hip", shirt.typical()), InvalidInput);
  EXPECT_THROW(shirt.evaluate("width", {}), InvalidInput);
  EXPECT_NEAR(shirt.evaluate("1 + width", shirt.typical()), 1.03, 1e-12);  // 1 cm + 102 cm
}

TEST(GarmentTemplate, FindsPossibleDimensionsNearImpossibleOnes) {
  const GarmentTemplate shirt = find_template("tshirt");
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    Dimensions wild;
    for (const Dimension& d : shirt.dimensions())
      wild[d.name] = -0.5 + 3.0 * static_cast<double>(random()) / 4294967296.0;
    wild["unknown"] = 1.0;
    if (i % 5 == 0) wild["width"] = std::nan("");
    if (i % 7 == 0) wild.erase("length");
    EXPECT_EQ(message_of(shirt, shirt.nearest_possible(wild)), "");
  }
  for (const Dimensions& d : test::possible_dimensions(shirt, 20))
    EXPECT_EQ(shirt.nearest_possible(d), d);
}

TEST(GarmentTemplate, DescribesItselfInCentimetres) {
  for (const std::string name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    const std::string text = describe_template(garment);
    for (const Dimension& d : garment.dimensions())
      EXPECT_NE(text.find(d.code + "  " + d.title + "  (" + d.name + ")"), std::string::npos);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 88u) << line;
  }
  EXPECT_NE(describe_template(find_template("skirt")).find("bounds 40.0 to 180.0 cm"),
            std::string::npos);
}

}  // namespace
}  // namespace regarment
