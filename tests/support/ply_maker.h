#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>

namespace regarment::test {

enum class PlyForm { Ascii, Little, Big };

/// Writes PLY files value by value, in any form and type, with code that shares nothing with the
/// reader or the writer under test.
class PlyMaker {
 public:
  explicit PlyMaker(PlyForm form) : form_(form) {
    static constexpr const char* kNames[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    text_ = std::string("ply\nformat ") + kNames[static_cast<int>(form)] + " 1.0\n";
  }

  PlyMaker& header(std::string_view line) {
    text_ += std::string(line) + "\n";
    return *this;
  }
  /// One value of the type so named; "uchar" and "uint8" mean the same.
  PlyMaker& value(std::string_view type, double v) {
    if (form_ == PlyForm::Ascii) {
      std::ostringstream out;
      out.precision(17);
      out << (row_open_ ? " " : "") << v;
      text_ += out.str();
      row_open_ = true;
      return *this;
    }
    if (type == "char" || type == "int8") put(static_cast<std::int8_t>(v));
    if (type == "uchar" || type == "uint8") put(static_cast<std::uint8_t>(v));
    if (type == "short" || type == "int16") put(static_cast<std::int16_t>(v));
    if (type == "ushort" || type == "uint16") put(static_cast<std::uint16_t>(v));
    if (type == "int" || type == "int32") put(static_cast<std::int32_t>(v));
    if (type == "uint" || type == "uint32") put(static_cast<std::uint32_t>(v));
    if (type == "float" || type == "float32") put(static_cast<float>(v));
    if (type == "double" || type == "float64") put(v);
    return *this;
  }
  PlyMaker& end_row() {
    if (form_ == PlyForm::Ascii) text_ += "\n";
    row_open_ = false;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  template <class Number>
  void put(Number number) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    const bool turn = (form_ == PlyForm::Little) != (std::endian::native == std::endian::little);
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      text_ += bytes[turn ? sizeof(Number) - 1 - i : i];
    }
  }

  PlyForm form_;
  std::string text_;
  bool row_open_ = false;
};

}  // namespace regarment::test
