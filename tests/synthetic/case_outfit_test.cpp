#include "synthetic/case_outfit.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "garment/find_template.h"
#include "synthetic/case_body.h"
#include "synthetic/case_fabric.h"

namespace regarment {
namespace {

TEST(CaseDice, EveryRunOfCasesHoldsItsShares) {
  // Of 50 neighbouring cases each fifth gets 10, give or take the discrepancy of the sequence.
  constexpr std::array<double, 5> kFifths = {0.2, 0.2, 0.2, 0.2, 0.2};
  for (const CaseChoice choice : {CaseChoice::Wear, CaseChoice::Kind, CaseChoice::Paint}) {
    std::array<int, 5> count{};
    for (std::uint32_t i = 1000; i < 1050; ++i) ++count[CaseDice(7, i, 0).pick(choice, kFifths)];
    for (const int n : count) EXPECT_NEAR(n, 10, 3);
  }
}

TEST(CaseDice, ChoicesDoNotFollowEachOther) {
  std::set<std::array<int, 2>> met;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const CaseDice dice(1, i, 0);
    met.insert({static_cast<int>(4 * dice.share(CaseChoice::Wear)),
                static_cast<int>(4 * dice.share(CaseChoice::Kind))});
  }
  EXPECT_EQ(met.size(), 16U);
}

TEST(CaseDice, AnotherAttemptKeepsTheSharesAndDrawsAnew) {
  CaseDice first(3, 12, 0), again(3, 12, 0), second(3, 12, 1), other(4, 12, 0);
  EXPECT_EQ(first.share(CaseChoice::Wear), second.share(CaseChoice::Wear));
  EXPECT_NE(first.share(CaseChoice::Wear), other.share(CaseChoice::Wear));
  const double drawn = first.uniform(0, 1);
  EXPECT_EQ(drawn, again.uniform(0, 1));
  EXPECT_NE(drawn, second.uniform(0, 1));
}

TEST(SampleFabric, IsAlwaysOne) {
  CaseDice dice(1, 0, 0);
  double thinnest = 1, thickest = 0;
  for (int i = 0; i < 300; ++i) {
    const SheetFabric fabric = sample_fabric(dice.uniform(0, 1), 0.005, dice);
    EXPECT_NO_THROW(fabric.check());
    thinnest = std::min(thinnest, fabric.thickness);
    thickest = std::max(thickest, fabric.thickness);
  }
  EXPECT_LT(thinnest, 0.0008);
  EXPECT_GT(thickest, 0.004);
  EXPECT_LE(sample_fabric(1, 0.002, dice).thickness, 0.002);
}

struct Worn {
  BodyGirths girths;
  Mesh body;
  std::vector<GarmentWish> garments;
};

Worn draw(Outfit outfit, std::uint32_t index) {
  CaseDice dice(5, index, 0);
  Worn out;
  out.body = make_body(sample_body(outfit, dice));
  out.girths = body_girths(out.body);
  out.garments = sample_garments(outfit, out.body, out.girths, dice);
  return out;
}

constexpr std::array<Outfit, 9> kAll = {
    Outfit::PencilSkirt,    Outfit::StraightSkirt,   Outfit::ALineSkirt,
    Outfit::FlaredSkirt,    Outfit::TightTshirt,     Outfit::Tshirt,
    Outfit::OversizeTshirt, Outfit::TshirtOverSkirt, Outfit::TuckedTshirt};

TEST(SampleGarments, AreLegalAndInTheOrderOfTheirNames) {
  std::uint32_t index = 0;
  for (const Outfit outfit : kAll) {
    for (int i = 0; i < 2; ++i) {
      const Worn worn = draw(outfit, index++);
      const std::vector<std::string> names = outfit_templates(outfit);
      ASSERT_EQ(worn.garments.size(), names.size());
      for (std::size_t g = 0; g < names.size(); ++g) {
        EXPECT_EQ(worn.garments[g].template_name, names[g]);
        EXPECT_NO_THROW(find_template(names[g]).check(worn.garments[g].dimensions));
        EXPECT_NO_THROW(worn.garments[g].fabric.check());
      }
    }
  }
}

TEST(SampleGarments, ASkirtHoldsWhereItIsWornAndGoesRoundTheLegs) {
  std::uint32_t index = 100;
  for (const Outfit outfit : {Outfit::PencilSkirt, Outfit::FlaredSkirt, Outfit::ALineSkirt}) {
    for (int i = 0; i < 3; ++i) {
      const Worn worn = draw(outfit, index++);
      const GarmentWish& skirt = worn.garments.front();
      const double there = tape_girth(worn.body, skirt.top_height);
      EXPECT_GT(skirt.dimensions.at("waist"), 0.93 * there);
      EXPECT_LT(skirt.dimensions.at("waist"), 1.045 * (there + 0.016));  // 5 mm of cloth
      EXPECT_LT(skirt.dimensions.at("waist"), worn.girths.hip);          // does not slip off
      const double hem = skirt.top_height - skirt.dimensions.at("length");
      EXPECT_GT(hem, 0.1);
      EXPECT_GT(skirt.dimensions.at("width"), tape_girth(worn.body, hem));
    }
  }
}

TEST(SampleGarments, ATuckedTshirtEndsInTheSkirtAndOneOverItBelowItsTop) {
  const Worn tucked = draw(Outfit::TuckedTshirt, 200);
  const Worn over = draw(Outfit::TshirtOverSkirt, 201);
  for (const Worn* worn : {&tucked, &over}) {
    const bool skirt_first = worn->garments.front().template_name == "skirt";
    EXPECT_EQ(skirt_first, worn == &tucked);
    const GarmentWish& skirt = worn->garments[skirt_first ? 0 : 1];
    const GarmentWish& tshirt = worn->garments[skirt_first ? 1 : 0];
    EXPECT_LT(worn->girths.neck_height - tshirt.dimensions.at("length"), skirt.top_height - 0.05);
  }
}

TEST(SampleGarments, SizesAreNotThoseOfTheBodyAlone) {
  // One body: lengths and flares range widely all the same.
  const Worn worn = draw(Outfit::ALineSkirt, 300);
  CaseDice dice(5, 301, 0);
  double shortest = 9, longest = 0, narrowest = 9, widest = 0;
  for (int i = 0; i < 40; ++i) {
    const Outfit outfit = i % 2 == 0 ? Outfit::FlaredSkirt : Outfit::ALineSkirt;
    const Dimensions d = sample_garments(outfit, worn.body, worn.girths, dice).front().dimensions;
    shortest = std::min(shortest, d.at("length")), longest = std::max(longest, d.at("length"));
    const double flare = d.at("width") / d.at("hip");
    narrowest = std::min(narrowest, flare), widest = std::max(widest, flare);
  }
  EXPECT_LT(shortest, 0.4);
  EXPECT_GT(longest, 0.75);
  EXPECT_LT(narrowest, 1.3);
  EXPECT_GT(widest, 1.9);
}

TEST(SampleBody, KeepsHandsOffTheHips) {
  for (std::uint32_t i = 0; i < 9; ++i) {
    CaseDice dice(9, i, 0);
    EXPECT_GE(arm_clearance(make_body(sample_body(kAll[i % kAll.size()], dice))), 0.025);
  }
}

}  // namespace
}  // namespace regarment
