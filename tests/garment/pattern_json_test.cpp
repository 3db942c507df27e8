#include "garment/pattern_json.h"

#include <cmath>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "garment_samples.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

Vec2 vertex(const Json& panel, int i) {
  const Json& v = panel.at("vertices").at(static_cast<std::size_t>(i));
  return {v.at(0).get<double>(), v.at(1).get<double>()};
}

double edge_length(const Json& panel, std::size_t edge) {
  const Json& ends = panel.at("edges").at(edge).at("endpoints");
  return (vertex(panel, ends[0].get<int>()) - vertex(panel, ends[1].get<int>())).norm();
}

TEST(PatternJson, IsAGarmentCodeSpecificationInCentimetres) {
  for (const std::string name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    for (const Dimensions& d : test::possible_dimensions(garment, 10)) {
      const Json json = Json::parse(pattern_json(garment, d));
      EXPECT_EQ(json.at("properties").at("units_in_meter"), 100);
      const Json& panels = json.at("pattern").at("panels");
      EXPECT_EQ(json.at("pattern").at("panel_order").size(), panels.size());
      std::map<std::string, double> free;  // by label
      for (const auto& [unused, panel] : panels.items()) {
        const std::size_t n = panel.at("vertices").size();
        ASSERT_EQ(panel.at("edges").size(), n);
        for (std::size_t e = 0; e < n; ++e) {
          EXPECT_EQ(panel.at("edges")[e].at("endpoints"), Json::array({e, (e + 1) % n}));
          if (panel.at("edges")[e].contains("label"))
            free[panel.at("edges")[e].at("label")] += edge_length(panel, e);
        }
      }
      EXPECT_NEAR(free.at("hem"), 100.0 * d.at("width"), 1e-6);
      if (name == "tshirt") {
        EXPECT_NEAR(free.at("left_cuff"), 100.0 * d.at("sleeve_opening"), 1e-6);
      }
      for (const Json& stitch : json.at("pattern").at("stitches")) {
        const auto length = [&](const Json& side) {
          return edge_length(panels.at(side.at("panel").get<std::string>()),
                             side.at("edge").get<std::size_t>());
        };
        EXPECT_NEAR(length(stitch[0]), length(stitch[1]), 1e-6);
      }
      for (const auto& [dimension, value] : d)
        EXPECT_NEAR(json.at("parameters").at(dimension).at("value").get<double>(), 100.0 * value,
                    1e-8);
    }
  }
}

TEST(PatternJson, WritesTheNeckAsACurveCloseToTheEllipse) {
  const GarmentTemplate shirt = find_template("tshirt");
  const Json json = Json::parse(pattern_json(shirt, shirt.typical()));
  const Json& front = json.at("pattern").at("panels").at("front");
  int curves = 0;
  for (std::size_t e = 0; e < front.at("edges").size(); ++e) {
    const Json& edge = front.at("edges")[e];
    if (!edge.contains("curvature")) continue;
    ++curves;
    ASSERT_EQ(edge.at("curvature").at("type"), "cubic");
    const Vec2 a = vertex(front, edge.at("endpoints")[0].get<int>());
    const Vec2 b = vertex(front, edge.at("endpoints")[1].get<int>());
    const Vec2 along = b - a, across(-along.y(), along.x());
    std::array<Vec2, 2> control;
    for (std::size_t k = 0; k < 2; ++k) {
      const Json& p = edge.at("curvature").at("params").at(k);
      control[k] = a + p[0].get<double>() * along + p[1].get<double>() * across;
    }
    for (double u = 0.0; u <= 1.0; u += 0.125) {
      const double v = 1.0 - u;
      const Vec2 p =
          v * v * v * a + 3 * u * v * v * control[0] + 3 * u * u * v * control[1] + u * u * u * b;
      // The usual cubic for a quarter circle is out by 0.027 % of the radius at most.
      EXPECT_NEAR(std::hypot(p.x() / 9.0, p.y() / 7.0), 1.0, 3e-4);
      EXPECT_LE(p.y(), 1e-9);  // y points up, the neck is cut down
    }
  }
  EXPECT_EQ(curves, 2);
}

TEST(PatternJson, IsTheSameEveryTimeAndRefusesTheImpossible) {
  const GarmentTemplate skirt = find_template("skirt");
  EXPECT_EQ(pattern_json(skirt, skirt.typical()), pattern_json(skirt, skirt.typical()));
  Dimensions stub = skirt.typical();
  stub["length"] = 0.1;
  EXPECT_THROW(pattern_json(skirt, stub), InvalidInput);
}

}  // namespace
}  // namespace regarment
