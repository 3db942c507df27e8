#include "report/borders_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/analyses.h"

namespace regarment {
namespace {

Analysis with_border(const Vec3& point) {
  Analysis analysis;
  analysis.scan = column_scan();
  GarmentAnalysis garment;
  garment.template_name = "skirt";
  garment.layer = 2;
  garment.borders = {{"hem", {point, Vec3(0, 0.5, 0.2), Vec3(-0.2, 0.5, 0)}, 0.75}};
  analysis.garments.push_back(std::move(garment));
  return analysis;
}

TEST(BordersJson, PointsAreInTheFrameAndUnitOfTheFile) {
  const auto json = nlohmann::json::parse(borders_json(with_border({0.2, 0.5, 0.1})));
  EXPECT_EQ(json["schema"], "regarment.borders/1");
  const auto& garment = json["garments"][0];
  EXPECT_EQ(garment["template"], "skirt");
  EXPECT_EQ(garment["layer"], 2);
  const auto& line = garment["lines"][0];
  EXPECT_EQ(line["edge"], "hem");
  EXPECT_EQ(line["shown"], 0.75);
  ASSERT_EQ(line["points"].size(), 3U);
  // Millimetres, z up, shifted by (100, 200, 300): see column_scan.
  EXPECT_EQ(line["points"][0], nlohmann::json({300.0, 100.0, 800.0}));
}

TEST(BordersJson, HasNoDigitsBeyondTenMicrometres) {
  const auto json = nlohmann::json::parse(borders_json(with_border({0.123456789, 0.5, 0.1})));
  EXPECT_EQ(json["garments"][0]["lines"][0]["points"][0][0], 223.46);
}

TEST(BordersJson, NoGarmentHasNoLines) {
  Analysis analysis = with_border(Vec3::Zero());
  analysis.garments[0].borders.clear();
  const auto json = nlohmann::json::parse(borders_json(analysis));
  EXPECT_EQ(json["garments"][0]["lines"], nlohmann::json::array());
}

}  // namespace
}  // namespace regarment
