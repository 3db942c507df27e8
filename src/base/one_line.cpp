#include "base/one_line.h"

#include <cstdint>

namespace regarment {
namespace {

unsigned byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
}

// Length of the UTF-8 character at `at`, or 0 when there is none that may be printed. C1 controls,
// overlong forms, surrogates, and the line and direction separators count as none.
std::size_t printable_length(std::string_view text, std::size_t at) {
  const unsigned first = byte_at(text, at);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  std::uint32_t point = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned next = byte_at(text, at + i);
    if ((next & 0xC0U) != 0x80U) return 0;
    point = point << 6U | (next & 0x3FU);
  }
  const bool overlong = (length == 3 && point < 0x800) || (length == 4 && point < 0x10000);
  const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
  const bool control = point < 0xA0 || (point >= 0x200E && point <= 0x200F) ||
                       (point >= 0x2028 && point <= 0x202E) || (point >= 0x2066 && point <= 0x2069);
  return overlong || surrogate || control || point > 0x10FFFF ? 0 : length;
}

}  // namespace

std::string one_line(std::string_view text, std::size_t most) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    if (at >= most) return line + "...";
    const std::size_t length = printable_length(text, at);
    if (length > 0) {
      line.append(text.substr(at, length));
      at += length;
      continue;
    }
    const unsigned byte = byte_at(text, at);
    line += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
    ++at;
  }
  return line;
}

}  // namespace regarment
