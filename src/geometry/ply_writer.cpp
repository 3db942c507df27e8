#include "geometry/ply_writer.h"

#include <array>
#include <bit>
#include <cstring>
#include <ostream>

#include "base/error.h"

namespace regarment {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian as we are");

constexpr std::size_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

void put(char*& at, double value) {
  const auto narrow = static_cast<float>(value);
  std::memcpy(at, &narrow, sizeof narrow);
  at += sizeof narrow;
}

}  // namespace

PlyWriter::Column& PlyWriter::add_column(std::size_t entries, std::string_view type,
                                         std::span<const std::string_view> names) {
  if (entries != vertices_) {
    throw InvalidInput("PlyWriter: property " + std::string(names[0]) + " has " +
                       std::to_string(entries) + " entries for " + std::to_string(vertices_) +
                       " vertices");
  }
  for (const std::string_view name : names) {
    properties_.append("property ").append(type).append(" ").append(name).append("\n");
  }
  const std::size_t width = names.size() * (type == "float" ? sizeof(float) : 1);
  columns_.push_back({width, std::string(width * vertices_, '\0')});
  return columns_.back();
}

PlyWriter& PlyWriter::positions(std::span<const Vec3> values) {
  char* at = add_column(values.size(), "float", std::array<std::string_view, 3>{"x", "y", "z"})
                 .data.data();
  for (const Vec3& p : values) {
    for (int axis = 0; axis < 3; ++axis) put(at, p[axis]);
  }
  return *this;
}

PlyWriter& PlyWriter::coordinates(std::span<const Vec2> values) {
  char* at =
      add_column(values.size(), "float", std::array<std::string_view, 2>{"s", "t"}).data.data();
  for (const Vec2& p : values) {
    for (int axis = 0; axis < 2; ++axis) put(at, p[axis]);
  }
  return *this;
}

PlyWriter& PlyWriter::colours(std::span<const Colour> values) {
  const std::array<std::string_view, 3> names{"red", "green", "blue"};
  char* at = add_column(values.size(), "uchar", names).data.data();
  for (const Colour& colour : values) {
    std::memcpy(at, colour.data(), colour.size());
    at += colour.size();
  }
  return *this;
}

PlyWriter& PlyWriter::column(std::string_view name, std::span<const std::uint8_t> values) {
  Column& column = add_column(values.size(), "uchar", {&name, 1});
  if (!values.empty()) std::memcpy(column.data.data(), values.data(), values.size());
  return *this;
}

PlyWriter& PlyWriter::column(std::string_view name, std::span<const double> values) {
  char* at = add_column(values.size(), "float", {&name, 1}).data.data();
  for (const double value : values) put(at, value);
  return *this;
}

PlyWriter& PlyWriter::column(std::string_view name, std::span<const float> values) {
  char* at = add_column(values.size(), "float", {&name, 1}).data.data();
  for (const float value : values) put(at, static_cast<double>(value));
  return *this;
}

PlyWriter& PlyWriter::triangles(std::span<const Triangle> values) {
  for (const Triangle& triangle : values) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= vertices_) {
        throw InvalidInput("PlyWriter: a triangle names vertex " + std::to_string(corner) + " of " +
                           std::to_string(vertices_));
      }
    }
  }
  triangles_.assign(values.begin(), values.end());
  return *this;
}

std::string PlyWriter::bytes() const {
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(vertices_) + "\n" + properties_;
  if (!triangles_.empty()) {
    file += "element face " + std::to_string(triangles_.size()) +
            "\nproperty list uchar int vertex_indices\n";
  }
  file += "end_header\n";

  std::size_t row_bytes = 0;
  for (const Column& column : columns_) row_bytes += column.width;
  const std::size_t header_bytes = file.size();
  file.resize(header_bytes + row_bytes * vertices_ + kFaceBytes * triangles_.size());
  char* at = file.data() + header_bytes;
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    for (const Column& column : columns_) {
      std::memcpy(at, column.data.data() + vertex * column.width, column.width);
      at += column.width;
    }
  }
  for (const Triangle& triangle : triangles_) {
    *at++ = 3;
    std::memcpy(at, triangle.data(), sizeof triangle);
    at += sizeof triangle;
  }
  return file;
}

void PlyWriter::write(std::ostream& out) const {
  const std::string file = bytes();
  out.write(file.data(), static_cast<std::streamsize>(file.size()));
}

}  // namespace regarment
