#include "pages/verdict_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/checks.h"
#include "results.h"

namespace regarment {
namespace {

using Json = nlohmann::json;

TEST(VerdictJson, HasTheChecksOfTheReport) {
  const Result result = example_result();
  const Json verdict = Json::parse(verdict_json(result));
  const std::vector<Check> checks = checks_of(result);
  ASSERT_EQ(verdict["checks"].size(), checks.size());
  constexpr std::array kLevels = {"good", "look", "poor"};
  for (std::size_t i = 0; i < checks.size(); ++i) {
    EXPECT_EQ(verdict["checks"][i]["name"], checks[i].name);
    EXPECT_EQ(verdict["checks"][i]["found"], checks[i].found);
    EXPECT_EQ(verdict["checks"][i]["advice"], checks[i].advice);
    EXPECT_EQ(verdict["checks"][i]["level"], kLevels[static_cast<std::size_t>(checks[i].level)]);
  }
  // Three of the skirt's four dimensions show on the scan.
  EXPECT_TRUE(verdict["headline"].get<std::string>().starts_with("3 of 4 dimensions measured"));
}

TEST(VerdictJson, ARemarkNeedsALook) {
  Result result = example_result();
  result.garments.clear();
  result.warnings = {"a <b>remark</b>"};
  const Json verdict = Json::parse(verdict_json(result));
  EXPECT_NE(verdict["level"], "good");
  EXPECT_EQ(verdict["warnings"], Json::array({"a <b>remark</b>"}));
}

TEST(VerdictJson, StandsNamesThatAreNoText) {
  Result result = example_result();
  result.warnings = {"bad \xff byte"};
  EXPECT_TRUE(Json::accept(verdict_json(result)));
}

}  // namespace
}  // namespace regarment
