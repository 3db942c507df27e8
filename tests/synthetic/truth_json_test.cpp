#include "synthetic/truth_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace regarment {
namespace {

using Json = nlohmann::json;

// A skirt of 60 cm whose waist and length are hidden, in millimetres and lying on its back.
CaseTruth a_case() {
  CaseTruth truth;
  truth.recipe.index = 3;
  truth.recipe.kind = ScanKind::ClosedMesh;
  truth.recipe.frame.units = "mm";
  truth.recipe.frame.up = "+z";
  truth.recipe.frame.yaw = 0.5235987755982988;  // 30 degrees
  truth.recipe.damage = {"noise", "holes"};
  truth.recipe.body.blend = {0.5, 0, 0, 0.5, 0, 0, 0, 0};
  const Dimensions flat = {{"length", 0.6}, {"width", 1.2}, {"waist", 0.8}, {"hip", 1.0}};
  const Dimensions worn = {{"length", 0.61}, {"width", 1.2}, {"waist", 0.82345678}, {"hip", 1.01}};
  truth.garments = {{"skirt", flat, worn, {"waist", "length"}}};
  truth.labels = {100, 50, 7};
  truth.given_up = {"skirt: did not come to rest"};
  return truth;
}

TEST(TruthJson, HasTheFieldsOfTheScansThatWereThere) {
  const Json json = Json::parse(truth_json(a_case()));
  EXPECT_EQ(json["name"], "case-0003");
  const Json& garment = json["garments"][0];
  EXPECT_EQ(garment["template"], "skirt");
  EXPECT_EQ(garment["layer"], 1);
  EXPECT_EQ(garment["measurements_cm"]["length"], 60.0);
  EXPECT_EQ(garment["worn_cm"]["waist"], 82.3457);  // to a micrometre
  EXPECT_EQ(garment["not_observable"], Json({"waist", "length"}));
  EXPECT_EQ(json["scan"]["unit"], "mm");
  EXPECT_EQ(json["scan"]["up"], "z");
  EXPECT_EQ(json["scan"]["yaw"], 30.0);
  EXPECT_EQ(json["scan"]["colour"], false);
  EXPECT_EQ(json["scan"]["open"], false);
  EXPECT_EQ(json["points"]["points"], 157);
  EXPECT_EQ(json["points"]["labels"], Json({{"0", 100}, {"1", 50}, {"255", 7}}));
}

TEST(TruthJson, TellsTheRecipeAndWhatWasGivenUp) {
  const Json json = Json::parse(truth_json(a_case()));
  EXPECT_EQ(json["recipe"]["kind"], "closed");
  EXPECT_EQ(json["recipe"]["damage"], Json({"noise", "holes"}));
  EXPECT_EQ(json["recipe"]["body"]["blend"], Json({{"female-average", 0.5}, {"female-slim", 0.5}}));
  EXPECT_EQ(json["given_up"][0], "skirt: did not come to rest");
}

TEST(TruthCsv, HasALinePerDimensionInTheTemplatesOrder) {
  std::istringstream lines(truth_csv_rows(a_case()));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line,
            "../case-0003.mesh.ply,closed,1,skirt,length,60.0,61.0,false,"
            "case-0003.mesh.labels.u8,noise; holes,mm,+z,+x");
  std::getline(lines, line);
  EXPECT_EQ(line,
            "../case-0003.mesh.ply,closed,1,skirt,width,120.0,120.0,true,"
            "case-0003.mesh.labels.u8,noise; holes,mm,+z,+x");
  int rest = 0;
  while (std::getline(lines, line)) ++rest;
  EXPECT_EQ(rest, 2);
}

}  // namespace
}  // namespace regarment
