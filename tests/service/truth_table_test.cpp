#include "service/truth_table.h"

#include <gtest/gtest.h>

#include "http/problem.h"

namespace regarment {
namespace {

const std::string kHead =
    "scan,layer,template,measurement,value_cm,published_cm,tol_minus_cm,tol_plus_cm\n";

TEST(TruthOfScan, KeepsTheRowsOfTheScanUnderItsNewName) {
  const std::string table =
      "scan,measurement,value_cm,colour\n"
      "one,length,54.5,red\n"
      "two.ply,length,60,blue\n";
  EXPECT_EQ(truth_of_scan(table, "two.ply", "scan.ply"),
            kHead + "scan.ply,,,length,60.000000,,,\n");
  EXPECT_EQ(truth_of_scan(table, "one.mesh.ply", "scan.ply"),
            kHead + "scan.ply,,,length,54.500000,,,\n");
}

TEST(TruthOfScan, OneScanNeedsNoName) {
  const std::string table = "scan,layer,template,measurement,value_cm\nx,2,skirt,S01,1\n";
  EXPECT_EQ(truth_of_scan(table, "", "scan.obj"), kHead + "scan.obj,2,skirt,S01,1.000000,,,\n");
}

TEST(TruthOfScan, ATableOfOneScanNeedNotNameIt) {
  EXPECT_EQ(truth_of_scan("template,value_cm,measurement\nskirt,54.5,length\n", "a.ply", "s.ply"),
            kHead + "s.ply,,skirt,length,54.500000,,,\n");
}

TEST(TruthOfScan, KeepsNamesThatAreHardToWrite) {
  const std::string name = "=a, \"b\"";
  EXPECT_EQ(truth_of_scan("measurement,value_cm\nlength,1\n", "", name),
            kHead + "\"=a, \"\"b\"\"\",,,length,1.000000,,,\n");
}

TEST(TruthOfScan, RefusesTablesThatSayNothingOfIt) {
  for (const char* table : {"", "a,b\n1,2\n", "scan,measurement,value_cm\n",
                            "scan,measurement,value_cm\na,length,1\nb,length,2\n",
                            "scan,measurement,value_cm\na,length,wide\n"})
    EXPECT_THROW(truth_of_scan(table, "c.ply", "scan.ply"), HttpProblem) << table;
}

}  // namespace
}  // namespace regarment
