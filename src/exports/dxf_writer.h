#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Puts a DXF file of the oldest form every program still reads (AC1009, ASCII, CR LF) together.
/// Coordinates in the file's unit, y up. Text is reduced to printable ASCII.
class DxfWriter {
 public:
  /// `layers`: every layer that entities name, in the order of the table.
  explicit DxfWriter(std::vector<std::string> layers) : layers_(std::move(layers)) {}

  /// What follows belongs to this block, until `end_block`.
  void begin_block(std::string_view name);
  void end_block();
  void insert(std::string_view block, const Vec2& at);

  void line(std::string_view layer, const Vec2& a, const Vec2& b);
  void polyline(std::string_view layer, const std::vector<Vec2>& points, bool closed);
  void point(std::string_view layer, const Vec2& at);
  /// A point with a direction (degrees, counter-clockwise from x) and a depth.
  void notch(std::string_view layer, const Vec2& at, double degrees, double depth);
  void text(std::string_view layer, const Vec2& at, double height, std::string_view text);

  /// The whole file; `low` and `high` are the corners of the drawing.
  std::string bytes(const Vec2& low, const Vec2& high) const;

 private:
  std::string& target() { return in_block_ ? blocks_ : entities_; }

  std::vector<std::string> layers_;
  std::string blocks_, entities_;
  bool in_block_ = false;
};

}  // namespace regarment
