#include "geometry/text_lines.h"

#include <cstring>
#include <type_traits>

#include "base/one_line.h"

namespace regarment {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// from_chars reports 1e400 and 1e-400 alike. Only the latter has a harmless value: zero.
bool is_tiny(std::string_view field) {
  const std::size_t exponent = field.find_first_of("eE");
  if (exponent != std::string_view::npos) return field.substr(exponent + 1).starts_with('-');
  const std::size_t digit = field.find_first_of("123456789");
  return digit != std::string_view::npos && field.find('.') < digit;
}

}  // namespace

bool LineReader::next() {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

bool LineReader::next_filled() {
  while (next()) {
    for (const char c : line_) {
      if (!is_blank(c)) return true;
    }
  }
  return false;
}

std::string_view Fields::word() {
  skip_blanks();
  const char* begin = at_;
  while (at_ != end_ && !is_blank(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

template <class Number>
Fields::Outcome Fields::parse(Number& value) {
  skip_blanks();
  if (at_ == end_) return Outcome::Missing;
  const char* begin = at_;
  // from_chars knows no leading plus, and "+-1" shall stay wrong.
  const char* digits = *begin == '+' && begin + 1 != end_ && begin[1] != '-' ? begin + 1 : begin;
  const auto [stop, error] = std::from_chars(digits, end_, value);
  if (stop != end_ && !is_blank(*stop)) return Outcome::NotANumber;
  if (error == std::errc::invalid_argument) return Outcome::NotANumber;
  at_ = stop;
  if (error == std::errc()) return Outcome::Ok;
  const std::string_view field(digits, static_cast<std::size_t>(stop - digits));
  if (std::is_floating_point_v<Number> && is_tiny(field)) {
    value = 0;
    return Outcome::Ok;
  }
  at_ = begin;
  return Outcome::TooLarge;
}

Fields::Outcome Fields::number(double& value) { return parse(value); }
Fields::Outcome Fields::whole(std::int64_t& value) { return parse(value); }

bool Fields::at_end() {
  skip_blanks();
  return at_ == end_;
}

std::size_t Fields::count_rest() const {
  Fields copy = *this;
  std::size_t count = 0;
  while (!copy.word().empty()) ++count;
  return count;
}

std::string describe(Fields::Outcome outcome, std::string_view field) {
  const std::string quoted = "'" + one_line(field, 40) + "'";
  switch (outcome) {
    case Fields::Outcome::Missing:
      return "a number is missing";
    case Fields::Outcome::TooLarge:
      return quoted + " is too large";
    default:
      return quoted + " is not a number";
  }
}

}  // namespace regarment
