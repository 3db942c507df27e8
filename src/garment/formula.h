#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace regarment {

/// Value of a name in a formula. Throws InvalidInput when there is no such name.
using NameLookup = std::function<double(std::string_view name)>;

/// A formula of a garment template, such as "min(0.86 * width / 4, 23.5)".
///
/// Numbers (decimal point, optional exponent), names ([a-z][a-z0-9_]*), + - * /, unary + and -,
/// parentheses, the constant pi, and the functions
///   min(a, b, ...)  max(a, b, ...)  sqrt(a)  abs(a)  pow(a, b)  hypot(a, b)
///   sin(a)  cos(a)  tan(a)  with a in radians  degrees(a): a degrees, in radians.
/// Formulas nest at most kMaxDepth deep and have at most kMaxLength characters.
class Formula {
 public:
  static constexpr int kMaxDepth = 32;
  static constexpr std::size_t kMaxLength = 400;

  /// The constant 0.
  Formula() : Formula(0.0) {}
  explicit Formula(double constant);
  /// Throws InvalidInput that names the column (from 1) and what was expected there.
  static Formula parse(const std::string& text);

  /// Throws InvalidInput on an unknown name, a division by zero, a root of a negative number or a
  /// value that is not finite.
  double evaluate(const NameLookup& lookup) const;

  const std::string& text() const { return text_; }
  /// The names it uses, each once, in order of appearance.
  std::vector<std::string> names() const;
  bool is_zero_constant() const;

 private:
  enum class Op {
    Number,
    Name,
    Add,
    Subtract,
    Multiply,
    Divide,
    Negate,
    Min,
    Max,
    Sqrt,
    Abs,
    Pow,
    Hypot,
    Sin,
    Cos,
    Tan,
    Degrees
  };
  struct Step {
    Op op;
    double number = 0.0;  // Number
    std::string name;     // Name
    int arguments = 0;    // how many values it takes from the stack
  };
  class Parser;
  double apply(const Step& step, const double* arguments) const;

  std::string text_;
  std::vector<Step> steps_;  // reverse Polish: evaluation needs a stack and no recursion
};

}  // namespace regarment
