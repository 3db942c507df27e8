#include "garment/svg_text.h"

#include <cstdio>

namespace regarment {

std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string svg_number(double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.2f", value);
  std::string text = buffer;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string svg_point(const Vec2& p) { return svg_number(p.x()) + "," + svg_number(p.y()); }

std::string svg_line(const std::string& css_class, const Vec2& a, const Vec2& b) {
  return svg_path(css_class, "M" + svg_point(a) + " L" + svg_point(b));
}

std::string svg_path(const std::string& css_class, const std::string& d) {
  return "<path class=\"" + css_class + "\" d=\"" + d + "\"/>\n";
}

std::string svg_text(const std::string& css_class, const Vec2& p, const std::string& anchor,
                     const std::string& text, double degrees) {
  std::string turn;
  if (degrees != 0.0)
    turn = " transform=\"rotate(" + svg_number(degrees) + " " + svg_number(p.x()) + " " +
           svg_number(p.y()) + ")\"";
  return "<text class=\"" + css_class + "\" x=\"" + svg_number(p.x()) + "\" y=\"" +
         svg_number(p.y()) + "\" text-anchor=\"" + anchor + "\"" + turn + ">" + xml_escaped(text) +
         "</text>\n";
}

std::string svg_double_arrow(const std::string& css_class, const Vec2& a, const Vec2& b,
                             double head) {
  const Vec2 along = (b - a).normalized();
  const Vec2 across = 0.28 * head * Vec2(-along.y(), along.x());
  const auto tip = [&](const Vec2& p, const Vec2& inwards) {
    return svg_path(css_class + "-head", "M" + svg_point(p) + " L" +
                                             svg_point(p + head * inwards + across) + " L" +
                                             svg_point(p + head * inwards - across) + " Z");
  };
  return svg_line(css_class, a + 0.5 * head * along, b - 0.5 * head * along) + tip(a, along) +
         tip(b, -along);
}

}  // namespace regarment
