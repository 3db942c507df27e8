#include <gtest/gtest.h>

#include "analysis/stage.h"
#include "base/error.h"
#include "garment/find_template.h"

namespace regarment {
namespace {

/// A skirt's edges, and whether one of these girths is believed.
struct Skirt {
  GarmentTemplate garment = find_template("skirt");
  AnalyzeOptions options;
  GarmentEdges edges;

  Skirt() {
    edges.edges["waist"].limb = edges.edges["hem"].limb = "torso";
    edges.edges["waist"].garment_above = false;
  }
  bool stays_up(double waist, double hip, double width) const {
    const Stage stage{options, {}};
    const Dimensions at = {{"length", 0.6}, {"waist", waist}, {"hip", hip}, {"width", width}};
    try {
      check_stays_up(garment, at, edges, stage);
      return true;
    } catch (const NoGarmentError&) {
      return false;
    }
  }
};

TEST(StaysUp, OnlyWhatIsNarrowerAtTheTopThanSomewhereBelow) {
  const Skirt skirt;
  EXPECT_TRUE(skirt.stays_up(0.8, 1.0, 1.2));
  EXPECT_TRUE(skirt.stays_up(1.0, 1.01, 0.9));
  EXPECT_TRUE(skirt.stays_up(1.0, 0.9, 1.3));  // a flare holds as well
  EXPECT_FALSE(skirt.stays_up(1.1, 1.05, 1.0));
}

TEST(StaysUp, SaysWhatDoesNotFit) {
  Skirt skirt;
  const Stage stage{skirt.options, {}};
  const Dimensions at = {{"length", 0.6}, {"waist", 1.1}, {"hip", 1.05}, {"width", 1.0}};
  try {
    check_stays_up(skirt.garment, at, skirt.edges, stage);
    FAIL();
  } catch (const NoGarmentError& error) {
    EXPECT_NE(std::string(error.what()).find("would measure 110.0 cm"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("at most 105.0 cm"), std::string::npos);
  }
}

TEST(StaysUp, IsNotDoubtedWhereTheTopIsHiddenOrSaid) {
  Skirt covered;
  covered.edges.edges["waist"].covered = true;
  EXPECT_TRUE(covered.stays_up(1.1, 1.05, 1.0));
  Skirt said;
  said.options.placement.edges["skirt.waist"] = 1.02;
  EXPECT_TRUE(said.stays_up(1.1, 1.05, 1.0));
  Skirt known;
  known.options.fixed["skirt"] = {{"hip", 1.05}};
  EXPECT_TRUE(known.stays_up(1.1, 1.05, 1.0));
}

TEST(StaysUp, ShirtsHangFromTheShoulders) {
  Skirt shirt;
  shirt.edges.upper_body = true;
  EXPECT_TRUE(shirt.stays_up(1.1, 1.05, 1.0));
}

}  // namespace
}  // namespace regarment
