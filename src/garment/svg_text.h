#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Small pieces of SVG; coordinates in millimetres, x right, y down.

/// A text with the five characters of XML escaped.
std::string xml_escaped(const std::string& text);

/// A number with at most two decimals, without trailing zeros: "12.5".
std::string svg_number(double value);

/// "x,y"
std::string svg_point(const Vec2& p);

std::string svg_line(const std::string& css_class, const Vec2& a, const Vec2& b);
std::string svg_path(const std::string& css_class, const std::string& d);

/// `anchor`: "start", "middle" or "end". `degrees` turns the text about p, clockwise.
std::string svg_text(const std::string& css_class, const Vec2& p, const std::string& anchor,
                     const std::string& text, double degrees = 0.0);

/// A line with a filled arrow head of length `head` at both ends.
std::string svg_double_arrow(const std::string& css_class, const Vec2& a, const Vec2& b,
                             double head);

}  // namespace regarment
