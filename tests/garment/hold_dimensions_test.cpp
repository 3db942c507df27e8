#include "garment/hold_dimensions.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "garment/find_template.h"
#include "support/dice.h"
#include "support/texts.h"

namespace regarment {
namespace {

using test::Dice;

std::string refusal(const GarmentTemplate& garment, const Dimensions& held) {
  return refusal_of<UsageError>([&] { nearest_holding(garment, garment.typical(), held); });
}

TEST(HoldDimensions, LeavesPossibleOnesAlone) {
  const GarmentTemplate skirt = find_template("skirt");
  Dimensions wanted = skirt.typical();
  wanted["hip"] = 0.99;
  Dimensions expected = wanted;
  expected["length"] = 0.54;
  EXPECT_EQ(nearest_holding(skirt, wanted, {{"length", 0.54}}), expected);
}

TEST(HoldDimensions, HoldsExactlyAndMakesAGarmentOfTheRest) {
  const GarmentTemplate tshirt = find_template("tshirt");
  Dice dice(12);
  int moved = 0;
  for (int round = 0; round < 100; ++round) {
    Dimensions wanted;
    for (const Dimension& d : tshirt.dimensions()) wanted[d.name] = dice.uniform(d.lower, d.upper);
    // A wide body asks for a long sleeve seam, which the others must make room for.
    const Dimensions held = {{"width", dice.uniform(0.8, 1.7)}};
    const Dimensions found = nearest_holding(tshirt, wanted, held);
    EXPECT_EQ(found.at("width"), held.at("width"));
    EXPECT_NO_THROW(tshirt.check(found));
    for (const auto& [name, value] : wanted)
      if (!held.contains(name) && value != found.at(name)) {
        ++moved;
        break;
      }
  }
  // Neither all nor none of the draws can be made as they are.
  EXPECT_GT(moved, 5);
  EXPECT_LT(moved, 95);
}

TEST(HoldDimensions, NothingHeldIsTheNearestPossible) {
  const GarmentTemplate tshirt = find_template("tshirt");
  Dimensions wanted = tshirt.typical();
  wanted["width"] = 1.8, wanted["sleeve_seam"] = 0.2;
  EXPECT_EQ(nearest_holding(tshirt, wanted, {}), tshirt.nearest_possible(wanted));
}

TEST(HoldDimensions, RefusesWhatNoGarmentHas) {
  const GarmentTemplate skirt = find_template("skirt"), tshirt = find_template("tshirt");
  EXPECT_NE(refusal(skirt, {{"sleeve", 0.5}}).find("no dimension 'sleeve'"), std::string::npos);
  EXPECT_NE(refusal(skirt, {{"length", 5.4}}).find("22.0 to 125.0 cm"), std::string::npos);
  // A body 28 cm long ends above the underarm of a sleeve seam of 100 cm.
  const std::string both = refusal(tshirt, {{"length", 0.28}, {"sleeve_seam", 1.0}});
  EXPECT_NE(both.find("no garment has the dimensions that are fixed"), std::string::npos) << both;
}

}  // namespace
}  // namespace regarment
