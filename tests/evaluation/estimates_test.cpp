#include "evaluation/estimates.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "evaluation/evaluation_csv.h"
#include "evaluations.h"

namespace regarment {
namespace {

constexpr const char* kTruth =
    "scan,layer,template,measurement,value_cm\n"
    "a,1,tshirt,length,60\na,1,tshirt,width,100\na,2,skirt,length,54\n"
    "b.mesh.ply,1,skirt,hip,94\n";

std::vector<EvaluatedScan> compare(const std::string& estimates,
                                   const std::string& truth = kTruth) {
  return compare_estimates(CsvTable::parse(truth, "truth.csv"), "/nowhere",
                           CsvTable::parse(estimates, "other.csv"));
}

TEST(Estimates, BelongToTheScanTheyName) {
  const auto scans = compare(
      "scan,template,measurement,estimate_cm,low_cm,high_cm,observable\n"
      "a.cloud.ply,tshirt,width,101,99,103,true\n"
      "a.mesh.ply,tshirt,T02,98,,,false\n"
      "b,,hip,90,,,\n");
  ASSERT_EQ(scans.size(), 3u);
  EXPECT_EQ(scans[0].found[1]->value_cm, 101);
  EXPECT_EQ(scans[0].found[1]->low_cm, 99);
  EXPECT_FALSE(scans[0].found[0]);
  EXPECT_FALSE(scans[1].found[1]->observable);
  EXPECT_EQ(scans[2].found[0]->value_cm, 90);
  EXPECT_NEAR(scans[2].mean_error_cm().value(), 4, 1e-9);
}

TEST(Estimates, MayStandUnderTheNameOfTheTruth) {
  const auto scans = compare("scan,measurement,value_cm\nb.mesh.ply,hip,95\n");
  EXPECT_EQ(scans.at(0).found.at(0)->value_cm, 95);
}

TEST(Estimates, MaySayWhereTheReportIs) {
  const std::string head = "scan,measurement,value_cm,report\n";
  for (const char* address : {"/v1/jobs/1/report", "a/b.html#x:y", "https://a.b/c", ""}) {
    EXPECT_EQ(compare(head + "b,hip,95," + address + "\n").at(0).report, address);
  }
  for (const char* address : {"javascript:alert(1)", "JavaScript:x", "data:text/html,x", "a b",
                              "java\tscript:x", "\\\\host"}) {
    EXPECT_THROW(compare(head + "b,hip,95,\"" + address + "\"\n"), ReadError) << address;
  }
}

TEST(Estimates, ThatAreMissingAreFailures) {
  const auto scans = compare("scan,measurement,value_cm\nb.mesh.ply,hip,95\nunknown,hip,1\n");
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_FALSE(scans[0].failure);
  EXPECT_EQ(scans[1].failure->kind, "no estimate");
}

TEST(Estimates, MustSayWhichGarmentTheyMean) {
  EXPECT_THROW(compare("scan,measurement,value_cm\na,length,55\n"), ReadError);
  EXPECT_EQ(compare("scan,layer,measurement,value_cm\na,2,length,55\n").at(0).found.at(2)->value_cm,
            55);
}

TEST(Estimates, RefuseWhatCannotBeMeant) {
  EXPECT_THROW(compare("scan,measurement\na,width\n"), ReadError);
  EXPECT_THROW(compare("scan,measurement,value_cm\na,width,99\na,T02,98\n"), ReadError);
  EXPECT_THROW(compare("scan,measurement,value_cm,low_cm\na,width,99,98\n"), ReadError);
  EXPECT_THROW(compare("scan,measurement,value_cm,low_cm,high_cm\na,width,99,98,97\n"), ReadError);
  EXPECT_THROW(compare("scan,measurement,value_cm\na,width,1e7\n"), ReadError);
  EXPECT_THROW(compare("scan,measurement,value_cm\n,width,90\n"), ReadError);
  EXPECT_THROW(compare("scan,measurement,value_cm\nz,width,90\n"), UsageError);
}

TEST(Estimates, TakeAnEvaluationOfOurOwn) {
  EvaluatedScan scan = skirt_scan("b.mesh", {1, 2, 3, 4});
  scan.about.scan = "b.mesh.ply";
  const auto scans = compare(evaluation_csv(evaluation_of({scan, failed("c")})));
  EXPECT_NEAR(scans.at(0).found.at(0)->value_cm, 98, 1e-9);
  EXPECT_NEAR(scans.at(0).found.at(0)->low_cm.value(), 96, 1e-9);
}

}  // namespace
}  // namespace regarment
