#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace regarment {

/// Walks over the lines of a text in memory. Lines end with LF or CR LF, the last one may end with
/// the text. Nothing is copied.
class LineReader {
 public:
  /// `first_number` is the number of the line the text starts with.
  explicit LineReader(std::string_view text, std::size_t first_number = 1)
      : rest_(text), number_(first_number - 1) {}

  /// Moves to the next line; false when there is none.
  bool next();
  /// The same, passing over lines that are blank.
  bool next_filled();

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }   // of the current line, from 1
  std::string_view rest() const { return rest_; }  // what follows the current line

 private:
  std::string_view rest_, line_;
  std::size_t number_;
};

/// Takes the blank-separated fields of one line, from left to right.
class Fields {
 public:
  enum class Outcome { Ok, Missing, NotANumber, TooLarge };

  explicit Fields(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

  /// The next field, empty when there is none.
  std::string_view word();
  /// Reads a decimal number. "nan" and "inf" are read as such; 1e400 is TooLarge, 1e-400 is 0.
  Outcome number(double& value);
  /// Reads a whole number.
  Outcome whole(std::int64_t& value);
  bool at_end();
  /// How many fields are left.
  std::size_t count_rest() const;

 private:
  void skip_blanks() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\t')) ++at_;
  }
  template <class Number>
  Outcome parse(Number& value);

  const char* at_;
  const char* end_;
};

/// The words that go with an outcome other than Ok: "'1e400' is too large", "'x1' is not a number".
std::string describe(Fields::Outcome outcome, std::string_view field);

}  // namespace regarment
