#include "report/measurements_csv.h"

#include <gtest/gtest.h>

#include "report/csv_table.h"
#include "results.h"

namespace regarment {
namespace {

TEST(MeasurementsCsv, WritesOneRowPerDimension) {
  Result result = example_result();
  result.garments[0].measurements[1].fixed = true;
  EXPECT_EQ(measurements_csv(result),
            "layer,template,code,measurement,value_cm,low_cm,high_cm,worn_cm,observable,"
            "fixed,truth_cm,error_cm\n"
            "1,skirt,S01,length,54.30,53.50,55.10,,true,false,54.00,0.30\n"
            "1,skirt,S02,width,112.50,111.00,114.00,112.40,true,true,110.00,2.50\n"
            "1,skirt,S03,waist,78.40,77.20,79.60,80.10,true,false,78.00,0.40\n"
            "1,skirt,S04,hip,96.00,86.00,106.00,,false,false,,\n");
}

TEST(MeasurementsCsv, LeavesTruthOutWhenThereIsNone) {
  Result result = example_result();
  for (auto& m : result.garments[0].measurements) m.truth_cm.reset();
  const CsvTable table = CsvTable::parse(measurements_csv(result), "m.csv");
  EXPECT_FALSE(table.has("truth_cm"));
  EXPECT_EQ(table.size(), 4u);
}

TEST(MeasurementsCsv, GuardsTemplateNamesAgainstFormulas) {
  Result result = example_result();
  result.garments[0].template_name = "=cmd()";
  const CsvTable table = CsvTable::parse(measurements_csv(result), "m.csv");
  EXPECT_EQ(table.cell(0, "template"), "'=cmd()");
}

}  // namespace
}  // namespace regarment
