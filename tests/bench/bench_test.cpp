#include "bench/bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace regarment {
namespace {

TEST(GrowthExponent, IsThePowerOfAPowerLaw) {
  std::vector<GrowthCurve::Point> points;
  for (const double n : {20.0, 300.0, 5000.0, 70000.0})
    points.push_back({n, 3e-6 * std::pow(n, 1.37)});
  EXPECT_NEAR(growth_exponent(points), 1.37, 1e-12);
}

TEST(GrowthExponent, IsNothingWithoutTwoSizes) {
  EXPECT_EQ(growth_exponent({}), 0);
  EXPECT_EQ(growth_exponent({{5, 1}}), 0);
  EXPECT_EQ(growth_exponent({{5, 1}, {5, 2}}), 0);
  EXPECT_EQ(growth_exponent({{5, 1}, {9, 0}}), 0);  // too short for the clock
}

BenchRow time_row(double value) {
  return {.group = "G", .name = "a <b> & c", .value = value, .unit = "ms"};
}

TEST(BenchRow, JudgesTheValueOrTheRatio) {
  BenchRow row = time_row(2);
  EXPECT_FALSE(row.ratio().has_value());
  EXPECT_FALSE(row.reached().has_value());
  row.at_most = 2;
  EXPECT_TRUE(row.reached().value());
  row.at_most = 1.9;
  EXPECT_FALSE(row.reached().value());
  row.at_most.reset(), row.at_least = 4, row.by_ratio = true;
  EXPECT_FALSE(row.reached().has_value());  // nothing to compare with
  row.other = "X", row.other_value = 8;
  EXPECT_EQ(row.ratio().value(), 4);
  EXPECT_TRUE(row.reached().value());
  row.other_value = 7.9;
  EXPECT_FALSE(row.reached().value());
}

Bench small_bench() {
  Bench bench{"1.2.3", "x<y>.ply", {}, {}};
  bench.rows.push_back(time_row(2));
  bench.rows[0].other = "X", bench.rows[0].other_value = 8;
  bench.rows[0].at_least = 3, bench.rows[0].by_ratio = true;
  bench.rows.push_back({.group = "H", .name = "d", .value = 0.5, .unit = "s", .at_most = 0.25});
  bench.curves.push_back({"grows", "triangles", {{10, 0.001}, {1000, 0.1}}, 1});
  return bench;
}

TEST(BenchText, SaysWhatIsReached) {
  const std::string text = bench_text(small_bench());
  EXPECT_NE(text.find("2.00 ms"), std::string::npos);
  EXPECT_NE(text.find("X 8.00 ms, 4.0 times"), std::string::npos);
  EXPECT_NE(text.find("reached: at least 3.00 times"), std::string::npos);
  EXPECT_NE(text.find("MISSED: at most 0.250 s"), std::string::npos);
  EXPECT_NE(text.find("size^1.00"), std::string::npos);
}

TEST(BenchJson, HoldsEverything) {
  const auto json = nlohmann::json::parse(bench_json(small_bench()));
  EXPECT_EQ(json.at("schema"), "regarment.bench/1");
  EXPECT_EQ(json.at("rows").at(0).at("ratio"), 4.0);
  EXPECT_EQ(json.at("rows").at(0).at("reached"), true);
  EXPECT_EQ(json.at("rows").at(1).at("reached"), false);
  EXPECT_FALSE(json.at("rows").at(1).contains("ratio"));
  EXPECT_EQ(json.at("curves").at(0).at("points").at(1).at("seconds"), 0.1);
}

TEST(BenchPage, IsEscapedAndRequestsNothing) {
  const std::string page = bench_page(small_bench());
  EXPECT_NE(page.find("a &lt;b&gt; &amp; c"), std::string::npos);
  EXPECT_EQ(page.find("x<y>"), std::string::npos);
  EXPECT_NE(page.find("content=\"default-src "), std::string::npos);
  EXPECT_EQ(page.find("http://"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_NE(page.find("<polyline"), std::string::npos);
}

TEST(BenchPage, LeavesOutACurveThatIsAPoint) {
  Bench bench = small_bench();
  bench.curves[0].points.resize(1);
  EXPECT_EQ(bench_page(bench).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace regarment
