#include "garment/formula.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace regarment {

namespace {

[[noreturn]] void fail(const std::string& text, const std::string& what) {
  throw InvalidInput("formula '" + text + "': " + what);
}

bool is_name_start(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_part(char c) { return is_name_start(c) || is_digit(c) || c == '_'; }

}  // namespace

/// Recursive descent whose depth is counted: sum -> product -> unary -> atom.
class Formula::Parser {
 public:
  Parser(const std::string& text, std::vector<Step>& steps) : text_(text), steps_(steps) {}

  void run() {
    sum(0);
    if (peek() != '\0') expected("an operator or the end");
  }

 private:
  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  [[noreturn]] void expected(const std::string& what) {
    fail(text_, "column " + std::to_string(at_ + 1) + ": expected " + what);
  }

  void emit(Op op, int arguments) { steps_.push_back({op, 0.0, {}, arguments}); }

  void sum(int depth) {
    if (depth > kMaxDepth)
      fail(text_, "nested more than " + std::to_string(kMaxDepth) + " deep; name a part of it");
    product(depth);
    for (;;) {
      if (accept('+')) {
        product(depth);
        emit(Op::Add, 2);
      } else if (accept('-')) {
        product(depth);
        emit(Op::Subtract, 2);
      } else {
        return;
      }
    }
  }

  void product(int depth) {
    unary(depth);
    for (;;) {
      if (accept('*')) {
        unary(depth);
        emit(Op::Multiply, 2);
      } else if (accept('/')) {
        unary(depth);
        emit(Op::Divide, 2);
      } else {
        return;
      }
    }
  }

  void unary(int depth) {
    bool negative = false;
    for (;;) {
      if (accept('-')) {
        negative = !negative;
      } else if (!accept('+')) {
        break;
      }
    }
    atom(depth);
    if (negative) emit(Op::Negate, 1);
  }

  void atom(int depth) {
    const char c = peek();
    if (is_digit(c) || c == '.') return number();
    if (is_name_start(c)) return name_or_call(depth);
    if (!accept('(')) expected("a number, a name, a function or '('");
    sum(depth + 1);
    if (!accept(')')) expected("')'");
  }

  void number() {
    double value = 0.0;
    const char* begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc()) expected("a number");
    at_ += static_cast<std::size_t>(end - begin);
    steps_.push_back({Op::Number, value, {}, 0});
  }

  void name_or_call(int depth) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_name_part(text_[at_])) ++at_;
    const std::string name = text_.substr(begin, at_ - begin);
    if (peek() == '(') return call(name, begin, depth);
    if (name == "pi") {
      steps_.push_back({Op::Number, std::numbers::pi, {}, 0});
    } else {
      steps_.push_back({Op::Name, 0.0, name, 0});
    }
  }

  void call(const std::string& name, std::size_t begin, int depth) {
    struct Function {
      const char* name;
      Op op;
      int fewest, most;
    };
    static constexpr Function kFunctions[] = {
        {"min", Op::Min, 2, 8},         {"max", Op::Max, 2, 8}, {"sqrt", Op::Sqrt, 1, 1},
        {"abs", Op::Abs, 1, 1},         {"pow", Op::Pow, 2, 2}, {"hypot", Op::Hypot, 2, 2},
        {"sin", Op::Sin, 1, 1},         {"cos", Op::Cos, 1, 1}, {"tan", Op::Tan, 1, 1},
        {"degrees", Op::Degrees, 1, 1},
    };
    const auto function = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                       [&](const Function& f) { return name == f.name; });
    if (function == std::end(kFunctions)) {
      fail(text_, "column " + std::to_string(begin + 1) + ": there is no function '" + name + "'");
    }
    accept('(');
    int arguments = 0;
    do {
      sum(depth + 1);
      ++arguments;
    } while (accept(','));
    if (!accept(')')) expected("',' or ')'");
    if (arguments < function->fewest || arguments > function->most) {
      fail(text_, name + " takes " + std::to_string(function->fewest) +
                      (function->most > function->fewest ? " or more" : "") + " arguments, not " +
                      std::to_string(arguments));
    }
    emit(function->op, arguments);
  }

  const std::string& text_;
  std::vector<Step>& steps_;
  std::size_t at_ = 0;
};

Formula::Formula(double constant) : text_(std::to_string(constant)) {
  steps_.push_back({Op::Number, constant, {}, 0});
}

Formula Formula::parse(const std::string& text) {
  if (text.size() > kMaxLength) {
    throw InvalidInput("formula of " + std::to_string(text.size()) + " characters; at most " +
                       std::to_string(kMaxLength) + ", name a part of it under 'derived'");
  }
  Formula formula;
  formula.text_ = text;
  formula.steps_.clear();
  Parser(formula.text_, formula.steps_).run();
  return formula;
}

double Formula::apply(const Step& step, const double* a) const {
  switch (step.op) {
    case Op::Number:
    case Op::Name:
      return step.number;
    case Op::Add:
      return a[0] + a[1];
    case Op::Subtract:
      return a[0] - a[1];
    case Op::Multiply:
      return a[0] * a[1];
    case Op::Divide:
      if (a[1] == 0.0) fail(text_, "division by zero");
      return a[0] / a[1];
    case Op::Negate:
      return -a[0];
    case Op::Min:
      return *std::min_element(a, a + step.arguments);
    case Op::Max:
      return *std::max_element(a, a + step.arguments);
    case Op::Sqrt:
      if (a[0] < 0.0) fail(text_, "square root of the negative number " + std::to_string(a[0]));
      return std::sqrt(a[0]);
    case Op::Abs:
      return std::abs(a[0]);
    case Op::Pow:
      return std::pow(a[0], a[1]);
    case Op::Hypot:
      return std::hypot(a[0], a[1]);
    case Op::Sin:
      return std::sin(a[0]);
    case Op::Cos:
      return std::cos(a[0]);
    case Op::Tan:
      return std::tan(a[0]);
    case Op::Degrees:
      return a[0] * std::numbers::pi / 180.0;
  }
  fail(text_, "unknown step");
}

double Formula::evaluate(const NameLookup& lookup) const {
  std::vector<double> stack;
  stack.reserve(steps_.size());
  for (const Step& step : steps_) {
    const std::size_t base = stack.size() - static_cast<std::size_t>(step.arguments);
    const double value = step.op == Op::Name ? lookup(step.name) : apply(step, stack.data() + base);
    if (!std::isfinite(value)) fail(text_, "the value is not a finite number");
    stack.resize(base);
    stack.push_back(value);
  }
  return stack.back();
}

std::vector<std::string> Formula::names() const {
  std::vector<std::string> names;
  for (const Step& step : steps_) {
    if (step.op == Op::Name && std::find(names.begin(), names.end(), step.name) == names.end())
      names.push_back(step.name);
  }
  return names;
}

bool Formula::is_zero_constant() const {
  return steps_.size() == 1 && steps_[0].op == Op::Number && steps_[0].number == 0.0;
}

}  // namespace regarment
