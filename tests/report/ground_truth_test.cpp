#include "report/ground_truth.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "report/files.h"
#include "support/folders.h"

namespace regarment {
namespace {

std::vector<TruthRow> rows(const std::string& text) {
  return truth_rows(CsvTable::parse(text, "t.csv"));
}

GarmentAnalysis garment(const std::string& name, int layer) {
  GarmentAnalysis out;
  out.template_name = name;
  out.layer = layer;
  for (const char* measurement : {"length", "waist"}) {
    Measurement m;
    m.name = measurement;
    m.code = std::string(1, name[0]) + "-" + measurement;
    out.measurements.push_back(m);
  }
  return out;
}

Analysis layered() {
  Analysis analysis;
  analysis.garments = {garment("tshirt", 1), garment("skirt", 2)};
  return analysis;
}

TEST(TruthRows, ReadsBothNamesOfAColumnAndIgnoresOthers) {
  const auto r = rows(
      "note,ground_truth_cm,measurement,scan,published_estimate_cm,tol_minus_cm,tol_plus_cm,layer\n"
      "x,54,length,a,56.5,0.5,1,2\n");
  ASSERT_EQ(r.size(), 1u);
  EXPECT_DOUBLE_EQ(r[0].value, 0.54);
  EXPECT_DOUBLE_EQ(*r[0].published, 0.565);
  EXPECT_DOUBLE_EQ(*r[0].tol_minus, 0.005);
  EXPECT_DOUBLE_EQ(*r[0].tol_plus, 0.01);
  EXPECT_EQ(*r[0].layer, 2);
}

TEST(TruthRows, RefusesWhatIsNotALength) {
  const std::string head = "scan,measurement,value_cm,layer,tol_plus_cm\n";
  for (const std::string row :
       {"a,length,abc,1,", "a,length,-5,1,", "a,length,0,1,", "a,length,540000,1,", "a,length,5,0,",
        "a,length,5,1.5,", "a,length,5,1,-1", ",length,5,1,", "a,,5,1,"}) {
    EXPECT_THROW(rows(head + row + "\n"), ReadError) << row;
  }
  EXPECT_TRUE(rows(head + "a,length,,1,\n").empty());
}

TEST(TruthRows, NeedsItsColumns) {
  EXPECT_THROW(rows("measurement,value_cm\n"), ReadError);
  EXPECT_THROW(rows("scan,value_cm\n"), ReadError);
  EXPECT_THROW(rows("scan,measurement\n"), ReadError);
}

TEST(RowsOfScan, MatchesPathNameAndStem) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  const auto scan = folder.path() / "sub/skirt-1.mesh.ply";
  write_file(scan, "x");
  const auto matches = [&](const std::string& written) {
    const auto all = rows("scan,measurement,value_cm\n" + written + ",length,1\n");
    return rows_of_scan(all, folder.path(), scan).size() == 1;
  };
  EXPECT_TRUE(matches("sub/skirt-1.mesh.ply"));
  EXPECT_TRUE(matches("skirt-1.mesh.ply"));
  EXPECT_TRUE(matches("skirt-1.mesh"));
  EXPECT_TRUE(matches("skirt-1"));
  EXPECT_FALSE(matches("skirt"));
  EXPECT_FALSE(matches("skirt-10"));
  EXPECT_FALSE(matches("skirt-1.cloud.ply"));
}

TEST(RowsOfScan, TheNearestKindOfMatchWins) {
  const auto all = rows(
      "scan,measurement,value_cm\nskirt-1,length,1\nskirt-1.mesh,length,2\nskirt-1.mesh.ply,length,"
      "3\n");
  const auto found = rows_of_scan(all, "/nowhere", "/else/skirt-1.mesh.ply");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].value, 0.03);
}

TEST(ApplyGroundTruth, FindsTheGarmentByTemplateOrLayer) {
  Analysis analysis = layered();
  apply_ground_truth(rows("scan,template,layer,measurement,value_cm\n"
                          "a,skirt,2,length,54\na,,1,waist,90\na,dress,1,length,3\n"
                          "a,tshirt,,t-length,60\n"),
                     "t.csv", analysis);
  EXPECT_DOUBLE_EQ(*analysis.garments[1].measurements[0].truth, 0.54);
  EXPECT_DOUBLE_EQ(*analysis.garments[0].measurements[1].truth, 0.90);
  EXPECT_DOUBLE_EQ(*analysis.garments[0].measurements[0].truth, 0.60);
  EXPECT_FALSE(analysis.garments[1].measurements[1].truth.has_value());
}

TEST(ApplyGroundTruth, TellsTwoOfOneTemplateApartByLayer) {
  Analysis analysis;
  analysis.garments = {garment("skirt", 1), garment("skirt", 2)};
  apply_ground_truth(
      rows("scan,template,layer,measurement,value_cm\na,skirt,2,length,54\na,skirt,1,length,60\n"),
      "t.csv", analysis);
  EXPECT_DOUBLE_EQ(*analysis.garments[0].measurements[0].truth, 0.60);
  EXPECT_DOUBLE_EQ(*analysis.garments[1].measurements[0].truth, 0.54);
}

TEST(ApplyGroundTruth, RefusesUnknownAndDoubleMeasurements) {
  Analysis analysis = layered();
  const std::string head = "scan,template,measurement,value_cm\n";
  EXPECT_THROW(apply_ground_truth(rows(head + "a,skirt,girth,5\n"), "t.csv", analysis), ReadError);
  EXPECT_THROW(
      apply_ground_truth(rows(head + "a,skirt,length,5\na,skirt,length,6\n"), "t.csv", analysis),
      ReadError);
  EXPECT_THROW(apply_ground_truth(rows(head + "a,dress,length,5\n"), "t.csv", analysis),
               UsageError);
}

}  // namespace
}  // namespace regarment
