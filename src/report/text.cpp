#include "report/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace regarment {
namespace {

constexpr std::string_view kMinus = "\u2212";

}  // namespace

std::string fixed_text(double value, int digits) {
  if (!std::isfinite(value)) return "?";
  std::array<char, 400> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, digits);
  std::string text(buffer.data(), end.ptr);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string cm_text(double metres) { return fixed_text(metres * 100.0, 1); }

std::string signed_cm_text(double metres) { return signed_text(metres * 100.0, 1); }

std::string signed_text(double value, int digits) {
  std::string text = fixed_text(value, digits);
  if (text.find_first_not_of("0.") == std::string::npos) return text;
  if (text.front() != '-') return "+" + text;
  return std::string(kMinus) + text.substr(1);
}

std::string significant_text(double value, int digits) {
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return "?";
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  return fixed_text(value, std::clamp(digits - before, 0, 12));
}

std::string short_text(double value) {
  int digits = 0;
  while (digits < 3 && std::abs(value - rounded(value, digits)) > 1e-9) ++digits;
  return fixed_text(value, digits);
}

std::string count_text(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, "\u202f");
  return text;
}

std::string duration_text(double seconds) {
  constexpr long kMinute = 60, kHour = 3600;
  const long whole = std::lround(seconds);
  if (whole < kMinute) return std::to_string(whole) + " s";
  if (whole < kHour) return std::to_string(whole / kMinute) + " min";
  return std::to_string(whole / kHour) + " h " + std::to_string(whole / kMinute % kMinute) + " min";
}

std::string shell_quoted(std::string_view argument) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./=:,@%";
  if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string_view::npos) {
    return std::string(argument);
  }
  std::string out = "'";
  for (const char c : argument) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = (group << 8) | (k < have ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += k <= have ? kAlphabet[(group >> (18 - 6 * k)) & 63] : '=';
    }
  }
  return out;
}

double rounded_significant(double value, int digits) {
  const std::string text = significant_text(value, digits);
  double out = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

double rounded(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  const double out = std::round(value * scale) / scale;
  return out == 0.0 ? 0.0 : out;
}

}  // namespace regarment
