#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Puts a binary little-endian PLY file together, column by column, then writes it at once:
///
///   PlyWriter(scan.positions.size()).positions(scan.positions).column("label", labels)
///       .column("probability", probability).colours(colours).triangles(scan.triangles).write(out);
///   PlyWriter(n).positions(p).coordinates(st).triangles(t).write(out);
///
/// Vertex properties stand in the order of the calls. Without `triangles` the file has no face
/// element. Each method throws InvalidInput when its argument does not have one entry per vertex
/// or an index is out of range. The same calls give the same bytes everywhere.
class PlyWriter {
 public:
  explicit PlyWriter(std::size_t vertices) : vertices_(vertices) {}

  PlyWriter& positions(std::span<const Vec3> values);    // float x y z
  PlyWriter& coordinates(std::span<const Vec2> values);  // float s t
  PlyWriter& colours(std::span<const Colour> values);    // uchar red green blue
  PlyWriter& column(std::string_view name, std::span<const std::uint8_t> values);  // uchar
  PlyWriter& column(std::string_view name, std::span<const double> values);        // float
  PlyWriter& column(std::string_view name, std::span<const float> values);         // float
  /// `list uchar int vertex_indices`, the only property of the faces.
  PlyWriter& triangles(std::span<const Triangle> values);

  /// The whole file.
  std::string bytes() const;
  /// Writes the whole file. The stream's state tells whether that worked; check it.
  void write(std::ostream& out) const;

 private:
  struct Column {
    std::size_t width;  // bytes per vertex
    std::string data;   // vertices_ * width bytes
  };
  Column& add_column(std::size_t entries, std::string_view type,
                     std::span<const std::string_view> names);

  std::size_t vertices_;
  std::string properties_;  // the header's lines
  std::vector<Column> columns_;
  std::vector<Triangle> triangles_;
};

}  // namespace regarment
