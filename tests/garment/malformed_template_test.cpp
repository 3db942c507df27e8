#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "garment/garment_template.h"
#include "support/texts.h"

#include <fstream>

namespace regarment {
namespace {

using Json = nlohmann::json;

Json good(const std::string& name) {
  std::ifstream stream(std::filesystem::path(TEMPLATE_FOLDER) / (name + ".json"));
  return Json::parse(stream);
}

std::string message_of(const std::string& text) {
  return refusal_of<ReadError>([&] { GarmentTemplate::parse(text, "bad.json"); });
}

struct Change {
  std::string name;     // template to spoil
  std::string pointer;  // what to replace
  Json value;           // by what; null removes it
  std::string says;
};

void expect_messages(const std::vector<Change>& changes) {
  for (const Change& change : changes) {
    Json json = good(change.name);
    if (change.value.is_null()) {
      const Json::json_pointer pointer(change.pointer);
      Json& parent = json.at(pointer.parent_pointer());
      if (parent.is_array()) {
        parent.erase(std::stoul(pointer.back()));
      } else {
        parent.erase(pointer.back());
      }
    } else {
      json[Json::json_pointer(change.pointer)] = change.value;
    }
    const std::string message = message_of(json.dump());
    EXPECT_TRUE(message.starts_with("bad.json: ")) << change.pointer << " says: " << message;
    EXPECT_NE(message.find(change.says), std::string::npos)
        << change.pointer << " says: " << message << "\n  instead of: " << change.says;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

const std::string kFront = "/pattern/panels/front";

TEST(MalformedTemplate, SaysWhereTheFormIsWrong) {
  expect_messages({
      {"skirt", "/format", "regarment.template/9", "/format: must be 'regarment.template/1'"},
      {"skirt", "/name", "My Skirt", "/name: 'My Skirt' is not a name"},
      {"skirt", "/title", "", "/title: must not be empty"},
      {"skirt", "/title", 5, "/title: must be a text in quotes"},
      {"skirt", "/colour", "red", "/: unknown key 'colour'"},
      {"skirt", "/dimensions", nullptr, "/: 'dimensions' is missing"},
      {"skirt", "/dimensions", Json::array(), "/dimensions: must have 1 to 12 entries, has 0"},
      {"skirt", "/dimensions/0/lower", "22", "/dimensions/0/lower: must be a number"},
      {"skirt", "/dimensions/0/lower", -3, "/dimensions/0/lower: must lie between"},
      {"skirt", "/dimensions/0/upper", 20, "/dimensions/0/upper: must be larger than 'lower'"},
      {"skirt", "/dimensions/0/typical", 500, "/dimensions/0/typical: must lie between 22 and 125"},
      {"skirt", "/dimensions/1/name", "length",
       "/dimensions/1/name: the name 'length' is already taken"},
      {"skirt", "/dimensions/1/name", "sqrt", "belongs to the formula language"},
      {"skirt", "/dimensions/1/code", "S01", "/dimensions/1/code: the code is already taken"},
      {"skirt", "/properties/units_in_meter", 0, "/properties/units_in_meter: must lie between"},
      {"skirt", "/constants/hip_depth", "20", "/constants/hip_depth: must be a number"},
      {"skirt", "/constants/waist", 3, "/constants/waist: the name 'waist' is already taken"},
      {"skirt", "/observations/0/edge", "cuff", "/observations/0/edge: there is no free edge"},
      {"skirt", "/observations/0/kind", "look", "/observations/0/kind: must be 'girth'"},
      {"skirt", "/observations/3/side", "left", "/observations/3/side: must be 'centre'"},
      {"skirt", "/drawing/measures/0/dimension", "bust",
       "/drawing/measures/0/dimension: there is no"},
      {"skirt", "/drawing/pieces/0/panels/0", "yoke",
       "/drawing/pieces/0/panels/0: there is no panel"},
  });
}

TEST(MalformedTemplate, SaysWhichFormulaIsWrong) {
  expect_messages({
      {"skirt", kFront + "/vertices/1/0", "waist / ",
       "/vertices/1/0: formula 'waist / ': column 9"},
      {"skirt", kFront + "/vertices/1/0", "bust / 4",
       "'bust' is no dimension, constant or earlier"},
      {"skirt", kFront + "/vertices/1/0", true, "/vertices/1/0: must be a text in quotes"},
      {"skirt", kFront + "/vertices/1/0", "waist / (hip_depth - 20)", "division by zero"},
      {"tshirt", "/derived/3/formula", "end_x",
       "/derived/3/formula: formula 'end_x': 'end_x' is no"},
      {"tshirt", "/derived/3/formula", "shoulder_z", "'shoulder_z' is no dimension"},
      {"tshirt", "/requires/0", nullptr, "square root of the negative number"},
      {"skirt", "/observations/0/equals", "width - 1000",
       "/observations/0/equals: is not positive"},
      {"skirt", "/requires/0/positive", "length - 100",
       "not met at typical dimensions: the hem must"},
      {"skirt", kFront + "/vertices/1/0", std::string(100, '(') + "1" + std::string(100, ')'),
       "nested more than 32 deep"},
      {"skirt", kFront + "/vertices/1/0", std::string(500, '1'), "must be shorter than 401"},
  });
}

TEST(MalformedTemplate, SaysWhichPanelIsWrong) {
  expect_messages({
      {"skirt", kFront + "/edges/1/endpoints/0", 2,
       "/edges/1/endpoints: joins a point with itself"},
      {"skirt", kFront + "/edges/1/endpoints/1", 3, "/edges/2/endpoints: the panel is not closed"},
      {"skirt", kFront + "/edges/1/endpoints/1", 9,
       "/edges/1/endpoints/1: must lie between 0 and 4"},
      {"skirt", kFront + "/cut_on_fold", false,
       "/edges/3/endpoints: the panel is not closed: the last"},
      {"skirt", kFront + "/edges/3", nullptr, "must pass every vertex exactly once"},
      {"skirt", kFront + "/vertices/0/0", "1",
       "a panel cut on the fold begins and ends on the fold"},
      {"skirt", kFront + "/vertices/1/0", "-waist / 4", "on the other side of the fold"},
      {"skirt", kFront + "/vertices/3/0", "0", "lie within half a millimetre of each other"},
      {"skirt", kFront + "/points/0/1", "length + 5", "crosses or touches itself"},
      {"skirt", kFront + "/points/0/0", "hip", "/points/0: lies outside the panel"},
      {"tshirt", kFront + "/lines/1/endpoints", Json::array({0, 1}),
       "/lines/1: runs outside the panel"},
      {"skirt", kFront + "/lines/0/endpoints", Json::array({1, 2}), "/lines/0: crosses or touches"},
      {"skirt", kFront + "/vertices/2/1", "length + 5", "the outline crosses or touches itself"},
      {"tshirt", kFront + "/edges/0/curvature/type", "spline",
       "/curvature/type: must be 'quadratic'"},
      {"tshirt", kFront + "/edges/0/curvature/segments", 1, "/segments: must lie between 2 and 32"},
      {"tshirt", kFront + "/limb", "tail", "/limb: must be torso"},
      {"tshirt", kFront + "/face", "side", "/face: must be 'front' or 'back'"},
      {"tshirt", "/pattern/panels/back/copy_of", "yoke",
       "/copy_of: names no panel that stands before"},
      {"tshirt", "/pattern/panels/back/copy_of", "left_sleeve_front",
       "names no panel that stands before"},
      {"tshirt", "/pattern/panel_order/1", "front", "/panel_order/1: the panel stands twice"},
      {"tshirt", "/pattern/panel_order/1", nullptr,
       "/panels/back: the panel is missing in panel_order"},
  });
}

TEST(MalformedTemplate, SaysWhichSeamIsWrong) {
  expect_messages({
      {"skirt", "/pattern/stitches/1", nullptr,
       "edge 'left_side' of panel 'front' is neither sewn nor a free edge"},
      {"skirt", "/pattern/stitches/1/0/panel", "yoke", "/stitches/1/0/panel: there is no panel"},
      {"skirt", "/pattern/stitches/1/0/edge", "seat", "panel 'front' has no edge of this name"},
      {"skirt", "/pattern/stitches/1/0/edge", "hem",
       "panel 'front' has several edges of this name"},
      {"skirt", "/pattern/stitches/1/0/edge", "left_hip_side",
       "/stitches/1: edge 'left_hip_side' of"},
      {"skirt",
       "/free_edges/cuff",
       {{"limb", "torso"}},
       "/free_edges/cuff: no panel has an unsewn"},
      {"skirt", "/free_edges/hem", nullptr, "edge 'hem' of panel 'front' is neither sewn nor"},
      {"skirt", "/pattern/panels/back/face", "front", "'hem' is not one closed loop"},
      {"skirt", "/pattern/stitches/0/1/edge", "right_hip_side", "is sewn twice"},
  });
  // Two edges of different length: the skirt's left hip seam is sewn to the other's lower side.
  Json json = good("skirt");
  json["/pattern/stitches/0/1/edge"_json_pointer] = "left_side";
  json["/pattern/stitches/1/1/edge"_json_pointer] = "left_hip_side";
  EXPECT_NE(
      message_of(json.dump()).find("/pattern/stitches/0: the two edges are 20.74 and 40.52 cm"),
      std::string::npos)
      << message_of(json.dump());
}

TEST(MalformedTemplate, SaysWhatGoesWrongAtTheBounds) {
  // Without its requirement a skirt shorter than its hip line folds over.
  Json folded = good("skirt");
  folded["requires"] = Json::array();
  folded["/dimensions/0/lower"_json_pointer] = 10;
  const std::string message = message_of(folded.dump());
  EXPECT_NE(message.find("the panel 'front' would fold over itself inside the bounds"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("length 10.0 cm"), std::string::npos) << message;

  // An arrow that is right at typical dimensions only.
  Json arrow = good("skirt");
  arrow["/drawing/measures/0/from/0"_json_pointer] = "-20.5";
  arrow["/drawing/measures/0/to/0"_json_pointer] = "20.5";
  EXPECT_NE(message_of(arrow.dump()).find("/drawing/measures/0: the arrow is 41.00 cm long"),
            std::string::npos)
      << message_of(arrow.dump());
}

TEST(MalformedTemplate, RefusesWhatIsNoJsonOrTooMuchOfIt) {
  EXPECT_EQ(message_of(""), "bad.json: not JSON: syntax error in line 1");
  EXPECT_EQ(message_of("{\n\n  \"a\": }"), "bad.json: not JSON: syntax error in line 3");
  EXPECT_EQ(message_of("[]"), "bad.json: /: must be an object");
  EXPECT_EQ(message_of("3"), "bad.json: /: must be an object");
  EXPECT_EQ(message_of("{\"a\": 1, \"a\": 2}"), "bad.json: the key 'a' stands twice in one object");
  EXPECT_EQ(message_of(std::string(100000, '[')), "bad.json: nested more than 16 levels deep");
  EXPECT_EQ(message_of(std::string(std::size_t{300} * 1024, ' ')),
            "bad.json: larger than 256 KiB, too large for a garment template");
  EXPECT_EQ(message_of("\"\xff\xfe\""), "bad.json: not JSON: syntax error in line 1");
  EXPECT_EQ(message_of("1e999"),
            "bad.json: not JSON: a number or a text in it cannot be represented");
  const std::string text = good("skirt").dump();
  for (std::size_t length = 0; length < text.size(); length += 37)
    EXPECT_NE(message_of(text.substr(0, length)), "") << length;
}

}  // namespace
}  // namespace regarment
