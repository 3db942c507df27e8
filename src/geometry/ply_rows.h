#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/one_line.h"
#include "geometry/mesh_builder.h"
#include "geometry/ply_header.h"
#include "geometry/text_lines.h"

namespace regarment {

// The body of a PLY file, read value by value. AsciiPlyRows and BinaryPlyRows have the same
// methods, so that one reader is written for both:
//   check_room(element)  before an element: the file is long enough for the smallest possible rows
//   begin_row, end_row   around each row
//   scalar, skip         one value of a type
//   index                one value of a type as a whole number
//   skip_many            so many values of a type
//   place                of the current row, for messages
//   check_end            after the last element: nothing but white space is left

class AsciiPlyRows {
 public:
  AsciiPlyRows(std::string_view file, const PlyHeader& header, const MeshBuilder& builder)
      : lines_(file.substr(header.bytes), header.lines + 1), builder_(builder) {}

  void check_room(const PlyElement& element) const {
    const std::size_t values = element.properties.size();
    // A value is a digit and a blank at least; the last blank may be missing.
    if (element.count > (lines_.rest().size() + 1) / (2 * values)) fail_truncated(element);
  }
  void begin_row(const PlyElement& element, std::uint64_t row) {
    if (lines_.next_filled()) {
      fields_ = Fields(lines_.line());
      return;
    }
    builder_.fail(place(), "the file ends after " + std::to_string(row) + " of " +
                               std::to_string(element.count) + " rows of element '" +
                               one_line(element.name, 40) + "'; it is cut off, export it again");
  }
  void end_row() {
    if (!fields_.at_end()) {
      builder_.fail(place(), "more values than the header declares; export the file again");
    }
  }
  double scalar(PlyScalar) {
    double value = 0;
    const Fields before = fields_;
    check(fields_.number(value), before);
    return value;
  }
  std::int64_t index(PlyScalar) {
    std::int64_t value = 0;
    const Fields before = fields_;
    check(fields_.whole(value), before);
    return value;
  }
  void skip(PlyScalar) {
    if (fields_.word().empty()) check(Fields::Outcome::Missing, fields_);
  }
  void skip_many(PlyScalar type, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) skip(type);
  }
  Place place() const { return {Place::Unit::Line, lines_.number()}; }
  void check_end() {
    if (!lines_.next_filled()) return;
    builder_.fail(place(), "more rows than the header declares; export the file again");
  }

 private:
  [[noreturn]] void fail_truncated(const PlyElement& element) const {
    builder_.fail({Place::Unit::Line, element.line},
                  std::to_string(element.count) + " rows of element '" +
                      one_line(element.name, 40) + "' do not fit into the " +
                      std::to_string(lines_.rest().size()) +
                      " bytes that follow; the file is cut off, export it again");
  }
  void check(Fields::Outcome outcome, Fields before) const {
    if (outcome == Fields::Outcome::Ok) return;
    builder_.fail(place(), describe(outcome, before.word()) + "; export the file again");
  }

  LineReader lines_;
  Fields fields_{std::string_view()};
  const MeshBuilder& builder_;
};

/// `Swap` is true for a file in the byte order this machine does not have.
template <bool Swap>
class BinaryPlyRows {
 public:
  BinaryPlyRows(std::string_view file, const PlyHeader& header, const MeshBuilder& builder)
      : begin_(file.data()),
        at_(begin_ + header.bytes),
        end_(begin_ + file.size()),
        row_(at_),
        builder_(builder) {}

  void check_room(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties) {
      least += size_of(property.is_list ? property.count_type : property.type);
    }
    // The header refuses rows without properties.
    // NOLINTNEXTLINE(clang-analyzer-core.DivideZero)
    if (element.count <= room() / least) return;
    builder_.fail({Place::Unit::Line, element.line},
                  std::to_string(element.count) + " rows of element '" +
                      one_line(element.name, 40) + "' take at least " + std::to_string(least) +
                      " bytes each, but " + std::to_string(room()) +
                      " follow; the file is cut off, export it again");
  }
  void begin_row(const PlyElement&, std::uint64_t) { row_ = at_; }
  void end_row() const {}
  double scalar(PlyScalar type) { return load<double>(type); }
  std::int64_t index(PlyScalar type) { return load<std::int64_t>(type); }
  void skip(PlyScalar type) { take(size_of(type)); }
  void skip_many(PlyScalar type, std::uint64_t count) {
    if (count > room() / size_of(type)) fail_truncated();
    at_ += count * size_of(type);
  }
  Place place() const { return {Place::Unit::Byte, static_cast<std::size_t>(row_ - begin_)}; }
  void check_end() {
    for (; at_ != end_; ++at_) {
      if (*at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\n') continue;
      row_ = at_;
      builder_.fail(place(), std::to_string(room()) +
                                 " bytes follow the last element; export the file again");
    }
  }

 private:
  std::size_t room() const { return static_cast<std::size_t>(end_ - at_); }
  [[noreturn]] void fail_truncated() const {
    builder_.fail(place(), "the file ends within this row; it is cut off, export it again");
  }
  const char* take(std::size_t bytes) {
    if (room() < bytes) fail_truncated();
    const char* taken = at_;
    at_ += bytes;
    return taken;
  }
  template <class To, class From>
  To load_as() {
    char bytes[sizeof(From)];
    const char* source = take(sizeof(From));
    for (std::size_t i = 0; i < sizeof(From); ++i) {
      bytes[i] = source[Swap ? sizeof(From) - 1 - i : i];
    }
    From value;
    std::memcpy(&value, bytes, sizeof(From));
    return static_cast<To>(value);
  }
  template <class To>
  To load(PlyScalar type) {
    switch (type) {
      case PlyScalar::Int8:
        return load_as<To, std::int8_t>();
      case PlyScalar::Uint8:
        return load_as<To, std::uint8_t>();
      case PlyScalar::Int16:
        return load_as<To, std::int16_t>();
      case PlyScalar::Uint16:
        return load_as<To, std::uint16_t>();
      case PlyScalar::Int32:
        return load_as<To, std::int32_t>();
      case PlyScalar::Uint32:
        return load_as<To, std::uint32_t>();
      default:
        break;
    }
    // Indices and counts are never floating-point: the header and the reader refuse that.
    if constexpr (std::is_floating_point_v<To>) {
      return type == PlyScalar::Float32 ? load_as<To, float>() : load_as<To, double>();
    }
    return {};
  }

  const char* begin_;
  const char* at_;
  const char* end_;
  const char* row_;
  const MeshBuilder& builder_;
};

}  // namespace regarment
