#include "evaluation/evaluation_table.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "support/folders.h"

namespace regarment {
namespace {

class EvaluationTable : public ::testing::Test {
 protected:
  std::vector<EvaluationCase> read(const std::string& text, const std::string& only = "") const {
    return read_evaluation_table(CsvTable::parse(text, "t.csv"), home_.path(), std::nullopt, only);
  }
  void expect_refused(const std::string& text, const std::string& says) const {
    try {
      read(text);
      ADD_FAILURE() << "took " << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  }
  void make(const std::string& name) const { std::ofstream(home_.path() / name) << "x"; }

  TemporaryFolder home_;
};

constexpr const char* kHead = "scan,layer,template,measurement,value_cm\n";

TEST_F(EvaluationTable, ReadsHowTheFileLiesInSpace) {
  make("a.mesh.ply");
  make("b.mesh.ply");
  const auto cases = read(
      "scan,template,measurement,value_cm,units,up,front\n"
      "a.mesh.ply,skirt,hip,94,mm,+z,+x;-y\nb.mesh.ply,skirt,hip,94,,,\n");
  ASSERT_EQ(cases.size(), 2u);
  const TrueFrame& frame = cases[0].frame;
  EXPECT_TRUE(frame.agrees("mm", "+z", "+x"));
  EXPECT_TRUE(frame.agrees("mm", "+z", "-y"));
  EXPECT_FALSE(frame.agrees("cm", "+z", "+x"));
  EXPECT_FALSE(frame.agrees("mm", "-z", "+x"));
  EXPECT_FALSE(frame.agrees("mm", "+z", "+y"));
  EXPECT_FALSE(cases[1].frame.said());
}

TEST_F(EvaluationTable, ACampaignNeedsNoTruth) {
  for (const char* name : {"a.ply", "b.ply", "c.ply"}) make(name);
  const auto campaign = [&](const std::string& text) {
    return read_campaign_table(CsvTable::parse(text, "t.csv"), home_.path(), std::nullopt, "");
  };
  const auto bare = campaign(
      "scan,layer,template,options\nb.ply,2,skirt,\nb.ply,1,tshirt,--up +z\n"
      "a.ply,,skirt,\n");
  ASSERT_EQ(bare.size(), 2u);
  EXPECT_EQ(bare[0].garments, (std::vector<std::string>{"tshirt", "skirt"}));
  EXPECT_EQ(bare[0].options, (std::vector<std::string>{"--up", "+z"}));
  EXPECT_TRUE(bare[0].dimensions.empty());
  // Where some are known, the others stay, in the table's order.
  const auto mixed = campaign(
      "scan,template,measurement,value_cm\na.ply,skirt,hip,\n"
      "b.ply,skirt,hip,94\nc.ply,skirt,waist,\n");
  ASSERT_EQ(mixed.size(), 3u);
  EXPECT_EQ(mixed[0].name, "a");
  EXPECT_EQ(mixed[1].dimensions.size(), 1u);
  EXPECT_TRUE(mixed[2].dimensions.empty());
  EXPECT_THROW(campaign("scan,template\na.ply,\n"), ReadError);
  EXPECT_THROW(campaign("scan,template\na.ply,cloak\n"), ReadError);
  EXPECT_THROW(campaign("scan,layer\na.ply,1\n"), ReadError);
}

// As many as a campaign has; looking at each row for each scan would take minutes.
TEST_F(EvaluationTable, ReadsTenThousandScans) {
  std::string text = kHead;
  for (int i = 0; i < 10'000; ++i) {
    const std::string scan = "scan-" + std::to_string(i) + ".ply";
    make(scan);
    for (const char* dimension : {"length", "width", "waist", "hip"})
      text += scan + ",1,skirt," + dimension + "," + std::to_string(40 + i % 50) + "\n";
  }
  const auto cases = read(text);
  ASSERT_EQ(cases.size(), 10'000u);
  EXPECT_EQ(cases[9'999].dimensions.size(), 4u);
  EXPECT_EQ(cases[9'999].dimensions[3].truth_cm, 40 + 9'999 % 50);
}

TEST_F(EvaluationTable, KnowsWhichScansShowOneGarment) {
  for (const char* name : {"a.mesh.ply", "a.cloud.ply", "b.ply", "c.ply"}) make(name);
  const auto cases = read(
      "scan,template,measurement,value_cm,tol_minus_cm,tol_plus_cm,garment\n"
      "a,skirt,hip,94,0.5,2,\nb.ply,skirt,hip,94,,,red\nc.ply,skirt,hip,94,,,red\n");
  ASSERT_EQ(cases.size(), 4u);
  EXPECT_EQ(cases[0].garment, "a");
  EXPECT_EQ(cases[1].garment, "a");
  EXPECT_EQ(cases[2].garment, "red");
  EXPECT_EQ(cases[3].garment, "red");
  EXPECT_NEAR(cases[0].dimensions[0].tol_minus_cm.value(), 0.5, 1e-9);
  EXPECT_NEAR(cases[0].dimensions[0].tol_plus_cm.value(), 2, 1e-9);
  EXPECT_FALSE(cases[2].dimensions[0].tol_plus_cm);
}

TEST_F(EvaluationTable, TakesAMeshAndACloudOfOneNameForOneGarment) {
  make("a.mesh.ply"), make("a.cloud.ply");
  const auto cases = read(
      "scan,template,measurement,value_cm\na.mesh.ply,skirt,hip,94\na.cloud.ply,skirt,hip,94\n");
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].garment, cases[1].garment);
}

TEST_F(EvaluationTable, ReadsWhatIsSaidOfAScan) {
  make("a.mesh.ply");
  make("a.mesh.labels.u8");
  const auto cases = read(
      "scan,template,measurement,value_cm,worn_cm,published_cm,observable,options,kind,damage\n"
      "a.mesh.ply,skirt,S04,94,97,90,true,--up +z  --units mm,,holes; noise\n"
      "a.mesh.ply,skirt,length,54.5,,,false,,open,\n");
  ASSERT_EQ(cases.size(), 1u);
  const EvaluationCase& one = cases.front();
  EXPECT_EQ(one.name, "a.mesh");
  EXPECT_EQ(one.scan, home_.path() / "a.mesh.ply");
  EXPECT_EQ(one.garments, std::vector<std::string>{"skirt"});
  EXPECT_EQ(one.labels, home_.path() / "a.mesh.labels.u8");
  EXPECT_EQ(one.options, (std::vector<std::string>{"--up", "+z", "--units", "mm"}));
  EXPECT_EQ(one.kind, "open");
  EXPECT_EQ(one.damage, (std::vector<std::string>{"holes", "noise"}));
  ASSERT_EQ(one.dimensions.size(), 2u);
  EXPECT_EQ(one.dimensions[0].measurement, "hip");
  EXPECT_TRUE(one.dimensions[0].circumference);
  EXPECT_NEAR(one.dimensions[0].truth_cm, 94, 1e-9);
  EXPECT_EQ(one.dimensions[0].worn_cm, 97);
  EXPECT_NEAR(one.dimensions[0].published_cm.value(), 90, 1e-9);
  EXPECT_EQ(one.dimensions[0].observable, true);
  EXPECT_TRUE(one.dimensions[1].hidden());
  EXPECT_FALSE(one.dimensions[1].circumference);
}

TEST_F(EvaluationTable, GivesOneCasePerFileOfAStem) {
  make("a.mesh.ply");
  make("a.cloud.ply");
  const auto cases = read(std::string(kHead) + "a,1,skirt,hip,94\n");
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].name, "a.cloud");
  EXPECT_EQ(cases[1].name, "a.mesh");
}

TEST_F(EvaluationTable, OrdersGarmentsByLayer) {
  const auto cases = read(std::string(kHead) + "a,2,skirt,hip,94\na,1,tshirt,width,98\n");
  EXPECT_EQ(cases.at(0).garments, (std::vector<std::string>{"tshirt", "skirt"}));
}

TEST_F(EvaluationTable, AGarmentMayBeNamedWithoutAValue) {
  const auto cases = read(std::string(kHead) + "a,2,skirt,hip,94\na,1,tshirt,width,\n");
  EXPECT_EQ(cases.at(0).garments, (std::vector<std::string>{"tshirt", "skirt"}));
  EXPECT_EQ(cases.at(0).dimensions.size(), 1u);
}

TEST_F(EvaluationTable, AScanThatIsNotThereIsACaseThatWillFail) {
  EXPECT_EQ(read(std::string(kHead) + "none.ply,1,skirt,hip,94\n").at(0).scan,
            home_.path() / "none.ply");
}

TEST_F(EvaluationTable, NamesAreFitForFoldersAndDiffer) {
  const auto cases =
      read(std::string(kHead) + "x/a b.ply,1,skirt,hip,94\n../a b.obj,1,skirt,hip,9\n" +
           "..,1,skirt,hip,9\n");
  ASSERT_EQ(cases.size(), 3u);
  EXPECT_EQ(cases[0].name, "a_b");
  EXPECT_EQ(cases[1].name, "a_b-2");
  EXPECT_EQ(cases[2].name, "_.");
}

TEST_F(EvaluationTable, OnlyTakesTheScansThatMatch) {
  const std::string text =
      std::string(kHead) + "skirt-1.ply,1,skirt,hip,94\nshirt.ply,1,skirt,hip,94\n";
  EXPECT_EQ(read(text, "skirt*").size(), 1u);
  EXPECT_EQ(read(text, "*.ply").size(), 2u);
  EXPECT_THROW(read(text, "none"), UsageError);
}

TEST_F(EvaluationTable, RefusesInOneLineThatSaysWhere) {
  const std::string head = kHead;
  expect_refused("measurement,value_cm\nhip,94\n", "'scan'");
  expect_refused(head, "names no scan");
  expect_refused(head + "a,1,,hip,94\n", "line 2, column template");
  expect_refused(head + "a,1,cape,hip,94\n", "line 2, column template");
  expect_refused(head + "a,1,skirt,inseam,94\n", "line 2, column measurement");
  expect_refused(head + "a,1,skirt,hip,94\na,1,skirt,S04,95\n", "line 3, column measurement");
  expect_refused(head + "a,1,skirt,hip,94\na,1,tshirt,width,95\n", "line 3, column template");
  expect_refused(head + "a,2,skirt,hip,94\n", "layer 1 of this scan is nowhere named");
  expect_refused(head + "a,9,skirt,hip,94\n", "8 layers");
  expect_refused("scan,template,measurement,value_cm,observable\na,skirt,hip,94,maybe\n",
                 "line 2, column observable");
  expect_refused("scan,template,measurement,value_cm,worn_cm\na,skirt,hip,94,-1\n",
                 "line 2, column worn_cm");
  expect_refused(
      "scan,template,measurement,value_cm,kind\na,skirt,hip,94,open\na,skirt,waist,70,closed\n",
      "line 3, column kind");
}

TEST_F(EvaluationTable, LabelsOfOneFileCannotBeThoseOfTwo) {
  make("a.mesh.ply");
  make("a.cloud.ply");
  expect_refused("scan,template,measurement,value_cm,labels\na,skirt,hip,94,a.u8\n", "labels");
}

TEST(YesOrNo, KnowsThreeWordsForEach) {
  const CsvTable table = CsvTable::parse("a,b\ntrue,\nno,\n1,\n", "t.csv");
  EXPECT_EQ(yes_or_no(table, 0, "a"), true);
  EXPECT_EQ(yes_or_no(table, 1, "a"), false);
  EXPECT_EQ(yes_or_no(table, 2, "a"), true);
  EXPECT_EQ(yes_or_no(table, 0, "b"), std::nullopt);
  EXPECT_EQ(yes_or_no(table, 0, "none"), std::nullopt);
}

}  // namespace
}  // namespace regarment
