#include "exports/pattern_dxf.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "garments.h"
#include "run_tool.h"
#include "support/folders.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

// The file has six digits after the point, so that a length of a few points is off by less.
constexpr double kFine = 1e-4;  // mm

Json read_by_ezdxf(const std::string& dxf) {
  const TemporaryFolder home;
  const std::string file = home.path() / "pattern.dxf";
  std::ofstream(file, std::ios::binary) << dxf;
  const auto there = run_tool({"/usr/bin/python3", "-c", "import ezdxf"});
  if (!there || there->status != 0) return nullptr;
  const auto run = run_tool({"/usr/bin/python3", beside_tests("read_dxf.py"), file});
  EXPECT_EQ(run->status, 0) << run->text;
  return Json::parse(run->text, nullptr, false);
}

/// What ezdxf reads, once for every pattern; null where it is not installed.
const Json& read_back(const std::string& dxf) {
  static std::map<std::string, Json> known;
  const auto found = known.find(dxf);
  return found != known.end() ? found->second : known[dxf] = read_by_ezdxf(dxf);
}

#define READ_BACK_OR_SKIP(json, dxf)                                    \
  const Json& json = read_back(dxf);                                    \
  if (json.is_null()) GTEST_SKIP() << "python3-ezdxf is not installed"; \
  ASSERT_FALSE(json.is_discarded())

TEST(PatternDxf, IsReadByEzdxfWithoutFault) {
  READ_BACK_OR_SKIP(json, pattern_dxf(find_template("tshirt"), whole_tshirt()));
  EXPECT_EQ(json["version"], "AC1009");
  EXPECT_EQ(json["errors"], Json::array());
  EXPECT_EQ(json["fixes"], Json::array());
  EXPECT_EQ(json["blocks"].size(), 6u);
  EXPECT_EQ(json["inserts"].size(), 6u);
}

TEST(PatternDxf, ASkirtHasItsTrueLengthsAndArea) {
  READ_BACK_OR_SKIP(json, pattern_dxf(find_template("skirt"), whole_skirt()));
  const double sides = 2.0 * (skirt_upper_side() + skirt_lower_side());
  for (const char* name : {"SKIRT-FRONT", "SKIRT-BACK"}) {
    const Json& block = json["blocks"][name];
    ASSERT_EQ(block["outlines"].size(), 1u);
    EXPECT_NEAR(block["perimeters"][0], 1000.0 * (0.36 + 0.60 + sides), kFine);
    EXPECT_NEAR(block["areas"][0], 1e6 * skirt_area(), 1.0);  // mm^2, of 294,000
    std::vector<double> seams = block["seams"];
    std::sort(seams.begin(), seams.end());
    ASSERT_EQ(seams.size(), 4u);
    EXPECT_NEAR(seams[0], 1000.0 * skirt_upper_side(), kFine);
    EXPECT_NEAR(seams[1], 1000.0 * skirt_upper_side(), kFine);
    EXPECT_NEAR(seams[2], 1000.0 * skirt_lower_side(), kFine);
    EXPECT_NEAR(seams[3], 1000.0 * skirt_lower_side(), kFine);
    EXPECT_EQ(block["internal"], 1);  // the hip line
    EXPECT_EQ(block["turns"], 8);     // four corners and the hip, and the two ends of the fold
  }
}

TEST(PatternDxf, ATShirtHasItsNeckAndShoulders) {
  READ_BACK_OR_SKIP(json, pattern_dxf(find_template("tshirt"), whole_tshirt()));
  const Json& front = json["blocks"]["TSHIRT-FRONT"];
  const std::vector<double> seams = front["seams"];
  const double sewn = std::accumulate(seams.begin(), seams.end(), 0.0);
  // What is not sewn is the neck and the hem. The neck's cubics and their chords of 3 mm are within
  // 0.1 mm of the ellipse.
  EXPECT_NEAR(front["perimeters"][0].get<double>() - sewn, 1000.0 * (neck_length() + 0.50), 0.1);
  const auto of_length = [&](double metres) {
    return std::count_if(seams.begin(), seams.end(),
                         [&](double s) { return std::abs(s - 1000.0 * metres) < kFine; });
  };
  EXPECT_EQ(of_length(shoulder_length()), 2);
  EXPECT_EQ(of_length(0.23), 2);  // half the sleeve seam
}

// A seam's notches lie in the middle of it; a back's armhole has two.
TEST(PatternDxf, SeamsAreMarkedAlikeOnBothSides) {
  READ_BACK_OR_SKIP(json, pattern_dxf(find_template("tshirt"), whole_tshirt()));
  const auto notches = [&](const char* name) { return json["blocks"][name]["notches"].size(); };
  // Front: two shoulders, armholes and sides, the two ends of the fold, the two of the chest line.
  EXPECT_EQ(notches("TSHIRT-FRONT"), 10u);
  EXPECT_EQ(notches("TSHIRT-BACK"), 12u);
  EXPECT_EQ(notches("TSHIRT-LEFT_SLEEVE_FRONT") + 1, notches("TSHIRT-LEFT_SLEEVE_BACK"));
}

TEST(PatternDxf, NotchesPointIntoThePiece) {
  READ_BACK_OR_SKIP(json, pattern_dxf(find_template("skirt"), whole_skirt()));
  for (const Json& notch : json["blocks"]["SKIRT-FRONT"]["notches"]) {
    const double x = notch[0], y = notch[1], depth = notch[2], angle = notch[3];
    EXPECT_NEAR(depth, 5.0, 1e-9);
    const double dx = std::cos(angle * M_PI / 180.0), dy = std::sin(angle * M_PI / 180.0);
    // Towards the middle of the piece, 30 cm down.
    EXPECT_GT(-x * dx + (-300.0 - y) * dy, 0.0) << x << " " << y << " " << angle;
  }
}

TEST(PatternDxf, LeftAndRightSleevesAreMirrorImages) {
  READ_BACK_OR_SKIP(json, pattern_dxf(find_template("tshirt"), whole_tshirt()));
  const auto corners = [&](const char* name, double side) {
    std::vector<std::pair<long, long>> out;  // micrometres
    for (const Json& p : json["blocks"][name]["outlines"][0])
      out.emplace_back(std::lround(side * 1000.0 * p[0].get<double>()),
                       std::lround(1000.0 * p[1].get<double>()));
    out.pop_back();
    std::sort(out.begin(), out.end());
    return out;
  };
  EXPECT_EQ(corners("TSHIRT-LEFT_SLEEVE_FRONT", 1.0), corners("TSHIRT-RIGHT_SLEEVE_FRONT", -1.0));
  // The right side of the cloth up: a back is turned over against its front.
  EXPECT_EQ(corners("TSHIRT-LEFT_SLEEVE_FRONT", 1.0), corners("TSHIRT-LEFT_SLEEVE_BACK", -1.0));
}

TEST(PatternDxf, SaysWhatItIs) {
  const std::string dxf = pattern_dxf(find_template("skirt"), whole_skirt());
  EXPECT_NE(dxf.find("UNITS: METRIC\r\n"), std::string::npos);
  EXPECT_NE(dxf.find("STYLE NAME: SKIRT\r\n"), std::string::npos);
  EXPECT_NE(dxf.find("PIECE NAME: SKIRT-FRONT\r\n"), std::string::npos);
  EXPECT_NE(dxf.find("S03 WAIST 72.0 CM\r\n"), std::string::npos);
  EXPECT_NE(dxf.find("NO SEAM ALLOWANCE"), std::string::npos);
  EXPECT_EQ(dxf, pattern_dxf(find_template("skirt"), whole_skirt()));
}

TEST(PatternDxf, RefusesWhatMakesNoGarment) {
  Dimensions none = whole_tshirt();
  none["sleeve_seam"] = 0.05;
  EXPECT_THROW(pattern_dxf(find_template("tshirt"), none), InvalidInput);
}

}  // namespace
}  // namespace regarment
