#pragma once

#include <string>

namespace regarment {

/// Writes the data of an SVG path, short: coordinates rounded to 0.1, one step relative to the
/// last, no character that is not needed. Rounding does not add up along the path.
class SvgPath {
 public:
  void move_to(double x, double y);
  /// A dot, where the stroke has round ends.
  void dot(double x, double y);
  void horizontal_to(double x);
  void vertical_to(double y);

  const std::string& text() const { return text_; }

 private:
  void number(long tenths, bool first);

  std::string text_;
  long x_ = 0, y_ = 0;  // tenths, where the pen is
};

/// A coordinate as in a path: "12.5", "-.3", "7".
std::string coordinate_text(double value);

/// The elements of a plot. `kind` is the class, by which the page styles it; `words` come escaped.
/// A path without data is nothing.
std::string path_element(const std::string& kind, const SvgPath& data);
std::string text_element(double x, double y, const std::string& kind, const std::string& words);

}  // namespace regarment
