#include "analysis/hidden_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "garment/find_template.h"

namespace regarment {
namespace {

/// An edge round the trunk at a height, covered or not.
GarmentEdge edge_at(double height, bool garment_above, bool covered) {
  GarmentEdge edge;
  edge.limb = "torso", edge.garment_above = garment_above, edge.covered = covered;
  edge.found.s.assign(16, height);
  return edge;
}

Body tall(double height) {
  Body body;
  body.height = height;
  return body;
}

/// What an upper garment whose hem is at `cut` hides of a skirt, on a person 1.7 m tall.
HiddenEdge waist_above(double cut) {
  GarmentEdges edges;
  edges.edges.emplace("waist", edge_at(cut, false, true));
  edges.edges.emplace("hem", edge_at(0.5, true, false));
  const auto hidden = hidden_edges(edges, tall(1.7));
  EXPECT_EQ(hidden.size(), 1U);
  return hidden.at("waist");
}

TEST(HiddenEdges, AreThoseThatAnotherGarmentCovers) {
  GarmentEdges edges;
  edges.edges.emplace("waist", edge_at(1.0, false, false));
  edges.edges.emplace("hem", edge_at(0.5, true, false));
  EXPECT_TRUE(hidden_edges(edges, tall(1.7)).empty());
}

// Far below where waists are, what hides it says nothing of the waist: it lies where waists lie,
// at 0.60 of the height, 0.028 of it up and down.
TEST(HiddenEdges, AWaistFarAboveTheOuterHemIsWhereWaistsAre) {
  const HiddenEdge waist = waist_above(0.7);
  EXPECT_NEAR(0.7 + waist.beyond, 0.60 * 1.7, 0.002);
  EXPECT_NEAR(waist.standard_deviation, 0.028 * 1.7, 0.001);
}

// The mean and deviation of a normal variable cut off below, by summing over its density.
TEST(HiddenEdges, AWaistIsNotBelowWhatHidesIt) {
  for (const double cut : {0.9, 0.97, 1.0, 1.05, 1.1}) {
    double sum = 0, mean = 0, square = 0;
    for (double y = cut + 0.02 + 5e-6; y < 1.5; y += 1e-5) {
      const double z = (y - 0.60 * 1.7) / (0.028 * 1.7), density = std::exp(-z * z / 2);
      sum += density, mean += density * y, square += density * y * y;
    }
    mean /= sum;
    const HiddenEdge waist = waist_above(cut);
    EXPECT_NEAR(cut + waist.beyond, mean, 1e-4) << cut;
    EXPECT_NEAR(waist.standard_deviation, std::sqrt(square / sum - mean * mean), 1e-4) << cut;
  }
}

TEST(HiddenEdges, StayFiniteWhereNoWaistCanBe) {
  for (const double cut : {1.3, 1.6, 5.0}) {
    const HiddenEdge waist = waist_above(cut);
    EXPECT_GE(waist.beyond, 0.02) << cut;
    EXPECT_TRUE(std::isfinite(waist.beyond)) << cut;
    EXPECT_GT(waist.standard_deviation, 0) << cut;
  }
}

TEST(HiddenEdges, AHemThatIsTuckedInLiesBelowTheOuterEdge) {
  GarmentEdges edges;
  edges.edges.emplace("hem", edge_at(1.0, true, true));
  const HiddenEdge hem = hidden_edges(edges, tall(1.7)).at("hem");
  EXPECT_GT(hem.beyond, 0.08);
  EXPECT_LT(hem.beyond, 0.16);
}

/// A skirt that tapers by 0.5 m of girth per m between hip and hem.
struct Skirt {
  GarmentTemplate garment = find_template("skirt");
  Dimensions dimensions = {{"length", 0.6}, {"waist", 0.8}, {"hip", 1.0}, {"width", 1.2}};
  std::vector<ObservedLength> observed;

  Skirt() {
    for (const Observation& o : garment.observations()) {
      observed.push_back({&o, 0, 0, o.equals == "width"});
      if (o.kind == Observation::Kind::Path) observed.back().value = 0.45;
    }
  }
};

TEST(HiddenDimensions, AHipThatShowsIsToldAsWellAsItsPlace) {
  const Skirt skirt;
  const auto found = hidden_dimensions({{"waist", {0.12, 0.04}}}, skirt.observed, skirt.dimensions,
                                       skirt.garment.typical());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_TRUE(found.at("hip").told);
  // 0.2 m of girth over the 0.4 m below the hip, times 4 cm.
  EXPECT_NEAR(found.at("hip").standard_deviation, 0.02, 1e-12);
}

TEST(HiddenDimensions, WhatLiesUnderTheOuterGarmentIsNotTold) {
  const Skirt skirt;
  const auto found = hidden_dimensions({{"waist", {0.25, 0.04}}}, skirt.observed, skirt.dimensions,
                                       skirt.garment.typical());
  EXPECT_FALSE(found.at("hip").told);
  EXPECT_FALSE(found.at("length").told);
  EXPECT_FALSE(found.at("waist").told);
  EXPECT_EQ(found.at("length").standard_deviation, 0.04);
  EXPECT_EQ(found.at("length").least, 0.45);
  // As skirts are cut, a hip of 1 m here, and far from certain.
  const Dimensions typical = skirt.garment.typical();
  EXPECT_NEAR(*found.at("waist").value, typical.at("waist") / typical.at("hip"), 1e-12);
  EXPECT_GT(found.at("waist").standard_deviation, 0.05);
  EXPECT_EQ(found.count("width"), 0U);
}

}  // namespace
}  // namespace regarment
