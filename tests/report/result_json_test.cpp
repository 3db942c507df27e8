#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/json_schema.h"
#include "results.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

TEST(ResultJson, HoldsWhatTheContractNames) {
  Result result = example_result();
  result.garments[0].measurements[1].fixed = true;
  const Json j = Json::parse(result_json(result));
  EXPECT_EQ(j.at("schema"), "regarment.result/1");
  EXPECT_EQ(j.at("program").at("method"), "direct");
  EXPECT_EQ(j.at("scan").at("up"), "+z");
  const Json& length = j.at("garments").at(0).at("measurements").at(0);
  EXPECT_EQ(length.at("name"), "length");
  EXPECT_EQ(length.at("code"), "S01");
  EXPECT_DOUBLE_EQ(length.at("value_cm"), 54.3);
  EXPECT_TRUE(length.at("worn_cm").is_null());
  EXPECT_DOUBLE_EQ(length.at("error_cm"), 0.3);
  EXPECT_EQ(length.at("fixed"), false);
  EXPECT_EQ(j.at("garments").at(0).at("measurements").at(1).at("fixed"), true);
  EXPECT_EQ(j.at("fabric"), "jersey");
  EXPECT_EQ(j.at("garments").at(0).at("error").at("silhouette"), 5.25);
  const Json& waist = j.at("garments").at(0).at("edges").at(0);
  EXPECT_EQ(waist.at("rivals"), Json::parse(R"([{"height_cm": 105.75, "weight": 0.3},
                                                {"height_cm": 98.0, "weight": 0.125}])"));
  const Json& girth = j.at("garments").at(0).at("measurements").at(2);
  EXPECT_EQ(girth.at("rivals"), Json::parse(R"([
      {"edges": ["waist"], "value_cm": 74.25, "weight": 0.3},
      {"edges": ["waist"], "value_cm": 82.5, "weight": 0.125}])"));
  EXPECT_FALSE(length.contains("rivals"));
  EXPECT_EQ(j.at("garments").at(0).at("asymmetry"), Json::parse(R"([
      {"name": "length", "sides": "left_right", "difference_cm": -1.5, "spread_cm": 0.75}])"));
  EXPECT_EQ(j.at("segmentation").at("garments").at(0), 14000);
  EXPECT_TRUE(j.at("timing_s").contains("total"));
}

TEST(ResultJson, ComesBackTheSame) {
  Result result = example_result();
  result.options = {{"units", "mm"}};
  result.threads = 2;
  result.scan.findings = {{"floor", Severity::Note, "A floor", "Left out", ""},
                          {"legs_touch", Severity::Problem, "The legs touch", "", "Again"}};
  result.scan.path = "scans/skirt-1.mesh.ply";
  result.label_score = LabelScore{40000, 0.98, 0.95, {0.97, std::nullopt}};
  result.figures = {{"scan", "front", "pictures/scan-front.jpg", 360, 640}};
  const std::string text = result_json(result);
  EXPECT_EQ(result_json(parse_result(text, "r")), text);
}

TEST(ResultJson, LeavesTimingOutWhenThereIsNone) {
  Result result = example_result();
  result.timing_s.clear();
  const Json j = Json::parse(result_json(result));
  EXPECT_FALSE(j.contains("timing_s"));
  EXPECT_FALSE(j.at("program").contains("threads"));
  EXPECT_FALSE(j.at("scan").contains("path"));
}

TEST(ResultSchema, RefusesEachFieldThatIsMissingOrOfAnotherKind) {
  const Json good = Json::parse(result_json(example_result()));
  for (const auto& item : good.items()) {
    if (item.key() == "timing_s") continue;
    Json missing = good, other = good;
    missing.erase(item.key());
    other[item.key()] = 7;
    EXPECT_THROW(check_by_result_schema(missing.dump(), "r"), ReadError) << item.key();
    EXPECT_THROW(check_by_result_schema(other.dump(), "r"), ReadError) << item.key();
  }
}

TEST(ResultSchema, NamesThePlace) {
  Json bad = Json::parse(result_json(example_result()));
  bad["garments"][0]["measurements"][2]["value_cm"] = "wide";
  try {
    check_by_result_schema(bad.dump(), "result.json");
    FAIL();
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("result.json: at /garments/0/measurements/2/value_cm"),
              std::string::npos)
        << error.what();
  }
}

TEST(ResultSchema, RefusesPicturesOutsideTheFolder) {
  for (const char* file : {"../../etc/passwd", "/etc/passwd", "pictures/../x.png"}) {
    Result result = example_result();
    result.figures = {{"scan", "front", file, 1, 1}};
    EXPECT_THROW(check_by_result_schema(result_json(result), "r"), ReadError) << file;
  }
}

TEST(ResultSchema, RefusesTextThatIsNoSoundJson) {
  EXPECT_THROW(check_by_result_schema("", "r"), ReadError);
  EXPECT_THROW(check_by_result_schema("{", "r"), ReadError);
  EXPECT_THROW(check_by_result_schema("{\"a\":1,\"a\":2}", "r"), ReadError);
  EXPECT_THROW(check_by_result_schema(std::string(100'000, '['), "r"), ReadError);
  EXPECT_THROW(check_by_result_schema("[1e999]", "r"), ReadError);
  EXPECT_THROW(check_by_result_schema("\"\xff\"", "r"), ReadError);
}

}  // namespace
}  // namespace regarment
