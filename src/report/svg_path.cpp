#include "report/svg_path.h"

#include <cmath>
#include <cstdlib>

namespace regarment {
namespace {

long tenths(double value) { return std::lround(value * 10.0); }

std::string text_of(long tenths) {
  std::string text = tenths < 0 ? "-" : "";
  const long size = std::labs(tenths);
  if (size >= 10 || size == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += "." + std::to_string(size % 10);
  return text;
}

}  // namespace

void SvgPath::number(long value, bool first) {
  if (!first && value >= 0) text_ += ' ';
  text_ += text_of(value);
}

void SvgPath::move_to(double x, double y) {
  const long new_x = tenths(x), new_y = tenths(y);
  text_ += 'm';
  number(new_x - x_, true);
  number(new_y - y_, false);
  x_ = new_x;
  y_ = new_y;
}

void SvgPath::dot(double x, double y) {
  move_to(x, y);
  text_ += "h0";
}

void SvgPath::horizontal_to(double x) {
  text_ += 'h';
  number(tenths(x) - x_, true);
  x_ = tenths(x);
}

void SvgPath::vertical_to(double y) {
  text_ += 'v';
  number(tenths(y) - y_, true);
  y_ = tenths(y);
}

std::string coordinate_text(double value) { return text_of(tenths(value)); }

std::string path_element(const std::string& kind, const SvgPath& data) {
  if (data.text().empty()) return {};
  return "<path class=\"" + kind + "\" d=\"" + data.text() + "\"/>";
}

std::string text_element(double x, double y, const std::string& kind, const std::string& words) {
  return "<text class=\"" + kind + "\" x=\"" + coordinate_text(x) + "\" y=\"" + coordinate_text(y) +
         "\">" + words + "</text>";
}

}  // namespace regarment
