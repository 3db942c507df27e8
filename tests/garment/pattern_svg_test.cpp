#include "garment/pattern_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "base/error.h"
#include "garment_samples.h"
#include "support/folders.h"
#include "support/texts.h"

namespace regarment {
namespace {

std::vector<Vec2> points_of(const std::string& svg, const std::string& css_class) {
  const std::regex path("<path class=\"" + css_class + "\" d=\"([^\"]*)\"");
  const std::regex point("(-?[0-9.]+),(-?[0-9.]+)");
  std::vector<Vec2> points;
  for (std::sregex_iterator p(svg.begin(), svg.end(), path), end; p != end; ++p) {
    const std::string d = (*p)[1];
    for (std::sregex_iterator q(d.begin(), d.end(), point); q != end; ++q)
      points.emplace_back(std::stod((*q)[1]), std::stod((*q)[2]));
  }
  return points;
}

TEST(PatternSvg, IsDrawnInMillimetres) {
  const GarmentTemplate skirt = find_template("skirt");
  for (const Dimensions& d : test::possible_dimensions(skirt, 20)) {
    const std::string svg = pattern_svg(skirt, d);
    Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
    for (const Vec2& p : points_of(svg, "rp-cut")) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double widest = std::max({d.at("waist"), d.at("hip"), d.at("width")});
    EXPECT_NEAR(high.x() - low.x(), 1000.0 * widest / 2.0, 0.02);  // two decimals at either end
    EXPECT_NEAR(high.y() - low.y(), 1000.0 * d.at("length"), 0.02);
    const std::regex size(
        "width=\"([0-9.]+)mm\" height=\"([0-9.]+)mm\"[^>]* "
        "viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(svg, match, size));
    EXPECT_EQ(match[1], match[3]);
    EXPECT_EQ(match[2], match[4]);
    EXPECT_LT(high.x(), std::stod(match[3]));
    EXPECT_LT(high.y(), std::stod(match[4]));
    EXPECT_GT(low.minCoeff(), 0.0);
  }
}

TEST(PatternSvg, ASketchHasLettersInTheOrderOfTheDimensions) {
  for (const std::string name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    const std::string svg =
        pattern_svg(garment, garment.typical(), {.style = PatternStyle::Sketch});
    EXPECT_EQ(count(svg, "class=\"rp-badge\""), garment.dimensions().size());
    char letter = 'A';
    for (std::size_t i = 0; i < garment.dimensions().size(); ++i, ++letter) {
      EXPECT_EQ(count(svg, std::string(">") + letter + "<"), 1u) << letter;
    }
    EXPECT_EQ(count(svg, "grain line") + count(svg, "cut 2") + count(svg, "No seam"), 0u);
  }
}

// The waist's arrow lies above the piece, its length above the arrow; the hem's below.
TEST(PatternSvg, TheLengthsOfASketchStandAwayFromThePiece) {
  const GarmentTemplate skirt = find_template("skirt");
  const std::string svg = pattern_svg(skirt, skirt.typical(), {.style = PatternStyle::Sketch});
  const std::regex badge("rp-badge\" cx=\"[0-9.]+\" cy=\"([0-9.]+)\"");
  const std::regex value("rp-value rp-halo\" x=\"[0-9.]+\" y=\"([0-9.]+)\"");
  std::vector<double> badges, values;
  for (std::sregex_iterator m(svg.begin(), svg.end(), badge), end; m != end; ++m)
    badges.push_back(std::stod((*m)[1]));
  for (std::sregex_iterator m(svg.begin(), svg.end(), value), end; m != end; ++m)
    values.push_back(std::stod((*m)[1]));
  ASSERT_EQ(badges.size(), 4u);  // waist, hip, hem, length, as the template draws them
  ASSERT_EQ(values.size(), 4u);
  EXPECT_LT(values[0], badges[0]);
  EXPECT_GT(values[2], badges[2]);
}

TEST(PatternSvg, ShowsEveryMeasurementWithCodeTitleAndLength) {
  for (const std::string name : {"skirt", "tshirt"}) {
    const GarmentTemplate garment = find_template(name);
    const std::string svg = pattern_svg(garment, garment.typical());
    for (const Dimension& d : garment.dimensions())
      EXPECT_NE(svg.find(">" + d.code + "  " + d.title + "<"), std::string::npos) << d.code;
    EXPECT_EQ(count(svg, "class=\"rp-measure\""), garment.dimensions().size());
    EXPECT_EQ(count(svg, "grain line"), 1u);
    EXPECT_NE(svg.find("cut 2"), std::string::npos);
    EXPECT_NE(svg.find("No seam allowance"), std::string::npos);
  }
  const GarmentTemplate shirt = find_template("tshirt");
  const std::string svg = pattern_svg(shirt, shirt.typical());
  EXPECT_NE(svg.find("\xC2\xBD = 51.0 cm"), std::string::npos);  // width 102
  EXPECT_NE(svg.find(">73.5 cm<"), std::string::npos);
}

TEST(PatternSvg, DrawsTheArmholesOfTheShirtOnceAsSeams) {
  const GarmentTemplate shirt = find_template("tshirt");
  const std::string svg = pattern_svg(shirt, shirt.typical());
  const std::vector<Vec2> seams = points_of(svg, "rp-seam");
  ASSERT_EQ(seams.size(), 4u);  // two lines
  for (const std::size_t i : {0u, 2u})
    EXPECT_NEAR((seams[i] - seams[i + 1]).norm(), 1000.0 * 0.47 / 2.0, 0.02);
  const std::string skirt_svg =
      pattern_svg(find_template("skirt"), find_template("skirt").typical());
  EXPECT_EQ(count(skirt_svg, "class=\"rp-seam\""), 0u);
}

TEST(PatternSvg, TakesTheInkOfThePageItIsInlinedIn) {
  const GarmentTemplate skirt = find_template("skirt");
  const std::string file = pattern_svg(skirt, skirt.typical());
  const std::string inlined = pattern_svg(skirt, skirt.typical(), {.standalone = false});
  EXPECT_TRUE(file.starts_with("<?xml"));
  EXPECT_TRUE(inlined.starts_with("<svg "));
  EXPECT_EQ(inlined.find("{color:"), std::string::npos);
  EXPECT_EQ(file, pattern_svg(skirt, skirt.typical()));
  // Rules of two drawings on one page must agree, whatever their scale.
  const auto style = [&](const Dimensions& d) {
    const std::string svg = pattern_svg(skirt, d, {.standalone = false});
    return svg.substr(svg.find("<style>"), svg.find("</style>") - svg.find("<style>"));
  };
  Dimensions small = skirt.typical();
  small["length"] = 0.3;
  small["width"] = 0.7;
  EXPECT_EQ(style(skirt.typical()), style(small));
}

TEST(PatternSvg, EscapesWordsFromTheTemplate) {
  std::string text = bytes_of(TEMPLATE_FOLDER "/skirt.json");
  const std::string title = "\"title\": \"Waist\"";
  text.replace(text.find(title), title.size(), "\"title\": \"<b>&'x'\"");
  const GarmentTemplate garment = GarmentTemplate::parse(text, "odd.json");
  const std::string svg = pattern_svg(garment, garment.typical());
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_NE(svg.find("&lt;b&gt;&amp;&#39;x&#39;"), std::string::npos);
  Dimensions stub = garment.typical();
  stub["length"] = 0.1;
  EXPECT_THROW(pattern_svg(garment, stub), InvalidInput);
  EXPECT_THROW(pattern_svg(garment, {}), InvalidInput);
}

}  // namespace
}  // namespace regarment
