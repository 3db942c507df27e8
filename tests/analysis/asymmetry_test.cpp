#include "analysis/asymmetry.h"

#include "findings.h"

namespace regarment {
namespace {

TEST(Asymmetry, MaySitInSleevesAndHems) {
  const auto sided_of = [](const std::string& name) {
    const GarmentTemplate garment = find_template(name);
    JointFit fit;
    fit.dimensions = garment.typical();
    fit.pattern = make_pattern(garment, fit.dimensions, 0.06);
    std::vector<std::string> out;
    for (const SidedDimension& s : sided_dimensions(garment, fit))
      out.push_back(s.name + (s.sides == Sides::LeftRight ? " left-right" : " front-back"));
    return out;
  };
  EXPECT_EQ(sided_of("skirt"),
            (std::vector<std::string>{"length left-right", "length front-back"}));
  const std::vector<std::string> shirt = sided_of("tshirt");
  EXPECT_EQ(std::count(shirt.begin(), shirt.end(), "sleeve_length left-right"), 1);
  EXPECT_EQ(std::count(shirt.begin(), shirt.end(), "sleeve_opening left-right"), 1);
  EXPECT_EQ(std::count(shirt.begin(), shirt.end(), "width left-right"), 0);
}

TEST(Asymmetry, IsSaidInWords) {
  const GarmentTemplate shirt = find_template("tshirt");
  EXPECT_EQ(asymmetry_in_words(shirt, {"sleeve_length", Sides::LeftRight, -0.021, 0.01}),
            "T-shirt: its left side is 2.1 cm shorter in " +
                shirt.dimension("sleeve_length").title +
                " than its right one (give or take 1.0 cm)");
}

// A frustum has like sides.
TEST(Asymmetry, IsNotSaidOfAnEvenSkirt) {
  test::PersonPlan plan;
  plan.skirt = test::MadeSkirt{1.03, 0.129, 0.45, 0.21};
  AnalyzeOptions options;
  options.method = Method::Joint;
  const Analysis found = analyze(test::scan_of(test::make_person(plan).mesh, plan.edge),
                                 test::templates_of({"skirt"}), options);
  EXPECT_TRUE(found.garments.at(0).asymmetry.empty());
}

}  // namespace
}  // namespace regarment
