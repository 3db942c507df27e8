#include "garment/formula.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"

namespace regarment {
namespace {

double lookup(std::string_view name) {
  if (name == "a") return 3.0;
  if (name == "b_2") return -4.0;
  if (name == "zero") return 0.0;
  throw InvalidInput("no name '" + std::string(name) + "'");
}

struct Value {
  const char* text;
  double value;
};

TEST(Formula, HasTheValueOfTheTable) {
  const Value table[] = {
      {"1", 1.0},
      {" 2.5e-1 ", 0.25},
      {".5", 0.5},
      {"1+2*3", 7.0},
      {"(1+2)*3", 9.0},
      {"8/4/2", 1.0},
      {"8-4-2", 2.0},
      {"-a", -3.0},
      {"--a", 3.0},
      {"-a*-b_2", -12.0},
      {"2*-3", -6.0},
      {"+a", 3.0},
      {"a/b_2", -0.75},
      {"min(a, b_2)", -4.0},
      {"max(1,2,3,2)", 3.0},
      {"sqrt(a*a+b_2*b_2)", 5.0},
      {"hypot(a, b_2)", 5.0},
      {"abs(b_2)", 4.0},
      {"pow(2, 10)", 1024.0},
      {"degrees(180)", std::numbers::pi},
      {"pi", std::numbers::pi},
      {"sin(degrees(90))", 1.0},
      {"cos(0)", 1.0},
      {"tan(0)", 0.0},
      {"min(0.86 * a / 4, 23.5)", 0.645},
      {"((((a))))", 3.0},
  };
  for (const Value& row : table)
    EXPECT_NEAR(Formula::parse(row.text).evaluate(lookup), row.value, 1e-15 * std::abs(row.value))
        << row.text;
}

struct Wrong {
  const char* text;
  const char* says;
};

TEST(Formula, RefusesWhatCannotBeRead) {
  const Wrong table[] = {
      {"", "column 1: expected a number"},
      {"1 +", "column 4: expected a number"},
      {"1 2", "column 3: expected an operator"},
      {"(1", "expected ')'"},
      {"1)", "column 2: expected an operator"},
      {"a $ 2", "column 3: expected an operator"},
      {"min(1)", "min takes 2 or more arguments, not 1"},
      {"sqrt(1, 2)", "sqrt takes 1 arguments, not 2"},
      {"foo(1)", "column 1: there is no function 'foo'"},
      {"min(1, 2", "expected ',' or ')'"},
      {"1e999", "expected a number"},
      {"1..2", "expected an operator"},
      {"a ^ 2", "expected an operator"},
      {"Width", "expected a number, a name"},
      {"nan(1)", "there is no function 'nan'"},
      {"\xc3\xa4", "expected a number, a name"},
  };
  for (const Wrong& row : table) {
    try {
      Formula::parse(row.text);
      ADD_FAILURE() << "read: " << row.text;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(row.says), std::string::npos)
          << row.text << " says: " << error.what();
    }
  }
}

TEST(Formula, RefusesWhatHasNoValue) {
  const Wrong table[] = {
      {"1 / zero", "division by zero"},         {"sqrt(b_2)", "square root of the negative number"},
      {"pow(b_2, 0.5)", "not a finite number"}, {"pow(10, 400)", "not a finite number"},
      {"1e300 * 1e300", "not a finite number"}, {"c", "no name 'c'"},
  };
  for (const Wrong& row : table) {
    const Formula formula = Formula::parse(row.text);
    try {
      formula.evaluate(lookup);
      ADD_FAILURE() << "has a value: " << row.text;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(row.says), std::string::npos)
          << row.text << " says: " << error.what();
    }
  }
}

TEST(Formula, LimitsDepthAndLength) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '(') + "1" +
           std::string(static_cast<std::size_t>(depth), ')');
  };
  EXPECT_EQ(Formula::parse(nested(Formula::kMaxDepth)).evaluate(lookup), 1.0);
  EXPECT_THROW(Formula::parse(nested(Formula::kMaxDepth + 1)), InvalidInput);
  const std::string many_minus(Formula::kMaxLength - 1, '-');
  EXPECT_EQ(std::abs(Formula::parse(many_minus + "1").evaluate(lookup)), 1.0);
  EXPECT_THROW(Formula::parse(many_minus + "12"), InvalidInput);
}

TEST(Formula, ListsItsNamesOnce) {
  const std::vector<std::string> expected = {"width", "s", "t"};
  EXPECT_EQ(Formula::parse("width + sqrt(s) * min(width, t) + pi").names(), expected);
}

}  // namespace
}  // namespace regarment
