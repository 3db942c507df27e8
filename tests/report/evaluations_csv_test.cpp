#include "report/evaluations_csv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "searches.h"

namespace regarment {
namespace {

class EvaluationsCsv : public testing::Test {
 protected:
  EvaluationsCsv() {
    set_trace(tiny_trace(), garment_);
    search_ = make_search(garment_, skirt_);
    csv_ = evaluations_csv(*garment_.trace);
  }

  std::vector<RunEvaluations> read(const std::string& csv) const {
    return read_evaluations(csv, "evaluations-1.csv", search_);
  }
  // The file with the first `from` in it replaced.
  std::string with(const std::string& from, const std::string& to) const {
    std::string csv = csv_;
    const auto at = csv.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return csv.replace(at, from.size(), to);
  }
  void refuses(const std::string& csv, const std::string& part) const {
    try {
      read(csv);
      FAIL() << part;
    } catch (const ReadError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find("evaluations-1.csv"), 0u) << error.what();
    }
  }

  GarmentTemplate skirt_ = find_template("skirt");
  GarmentAnalysis garment_;
  ResultSearch search_;
  std::string csv_;
};

TEST_F(EvaluationsCsv, HasOneRowPerEvaluation) {
  EXPECT_EQ(csv_,
            "run,evaluation,length_cm,distance_m,stretch,silhouette,error,best,temperature,"
            "drape_steps,came_to_rest\n"
            "1,1,50.000,0.250000,1.000000000,0.250000,0.500000,0.500000,0.0100000,7,true\n"
            "1,2,60.000,0.125000,1.000000000,0.125000,0.250000,0.250000,0.0100000,7,false\n"
            "1,3,55.000,0.125000,1.000000000,0.250000,0.375000,0.250000,0.0100000,7,true\n"
            "2,1,40.000,0.125000,1.000000000,,,,0.0100000,7,true\n"
            "2,2,45.000,0.0625000,1.000000000,0.0625000,0.125000,0.125000,0.0100000,7,true\n");
}

TEST_F(EvaluationsCsv, IsReadBackAsItWas) {
  const std::vector<RunEvaluations> runs = read(csv_);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].dimensions_cm, (std::vector<std::vector<double>>{{50.0, 60.0, 55.0}}));
  EXPECT_EQ(runs[0].error, (std::vector<double>{0.5, 0.25, 0.375}));
  EXPECT_EQ(runs[0].terms[2].silhouette, 0.25);
  EXPECT_TRUE(std::isnan(runs[1].error[0]));
  EXPECT_TRUE(std::isnan(runs[1].terms[0].silhouette));
  EXPECT_EQ(runs[1].terms[1].distance, 0.0625);
}

TEST_F(EvaluationsCsv, OfALongSearchStaysNearIt) {
  const FitTrace trace = made_trace(skirt_, 3, 500);
  set_trace(trace, garment_);
  const std::string csv = evaluations_csv(trace);
  EXPECT_LT(csv.size(), 200'000u);
  const auto runs = read_evaluations(csv, "evaluations-1.csv", make_search(garment_, skirt_));
  for (std::size_t r = 0; r < 3; ++r) {
    ASSERT_EQ(runs[r].error.size(), trace.runs[r].evaluations.size());
    for (std::size_t e = 0; e < runs[r].error.size(); ++e) {
      const FitEvaluation& was = trace.runs[r].evaluations[e];
      EXPECT_NEAR(runs[r].error[e] / was.error, 1.0, 1e-5);
      EXPECT_NEAR(runs[r].terms[e].stretch, was.terms.stretch, 1e-9);
      EXPECT_NEAR(runs[r].dimensions_cm[3][e], was.dimensions[3] * 100.0, 6e-4);
    }
  }
}

TEST_F(EvaluationsCsv, RowsThatAreMissingOrTooManyAreRefused) {
  refuses(csv_.substr(0, csv_.rfind("2,2,")), "ends at run 2, before its evaluation 2");
  refuses(csv_ + "2,3,45,1,1,1,1,1,1,1,true\n", "more evaluations than result.json");
  refuses(with("1,2,60", "1,3,60"), "line 3, column evaluation: must be 2");
  refuses(with("2,1,40", "1,4,40"), "line 5, column run: must be 2");
  refuses("", "is empty");
}

TEST_F(EvaluationsCsv, ColumnsThatAreMissingAreRefused) {
  refuses(with("length_cm", "width_cm"), "has no column 'length_cm'");
  refuses(with("error", "mistake"), "has no column 'error'");
  refuses(with(",7,true", ",true"), "line 2 has 10 cells, the header 11");
}

TEST_F(EvaluationsCsv, CellsThatAreNoSensibleNumbersAreRefused) {
  refuses(with("50.000", "nan"), "line 2, column length_cm");
  refuses(with("50.000", ""), "line 2, column length_cm: is empty");
  refuses(with("50.000", "1e300"), "line 2, column length_cm: is too large");
  refuses(with("0.250000", "inf"), "line 2, column distance_m");
  refuses(with("0.500000", "1e999"), "line 2, column error");
}

TEST_F(EvaluationsCsv, TheSmallestErrorMustBeWhereTheResultSaysItIs) {
  refuses(with("0.500000", "0.200000"), "run 1 does not have its smallest error at evaluation 2");
  refuses(with("0.125000,0.250000,0.250000,0.01", "0.125000,,0.250000,0.01"),
          "run 1 does not have its smallest error at evaluation 2");
}

}  // namespace
}  // namespace regarment
