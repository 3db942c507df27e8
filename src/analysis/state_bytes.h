#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.h"

namespace regarment {

static_assert(std::endian::native == std::endian::little, "states are little-endian files");

/// Puts values one after another into a string.
class StateWriter {
 public:
  template <typename T>
  void value(T v) {
    static_assert(std::is_arithmetic_v<T>);
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof v);
    std::memcpy(bytes_.data() + at, &v, sizeof v);
  }
  void text(std::string_view t) {
    value(static_cast<std::uint32_t>(t.size()));
    bytes_ += t;
  }
  /// Seven bits a byte, small ones first: small numbers take little room.
  void number(std::uint64_t v) {
    for (; v >= 0x80; v >>= 7U) value(static_cast<std::uint8_t>(v | 0x80U));
    value(static_cast<std::uint8_t>(v));
  }
  /// A number that may be negative; near zero it takes little room.
  void difference(std::int64_t v) {
    number((static_cast<std::uint64_t>(v) << 1U) ^ static_cast<std::uint64_t>(v >> 63U));
  }
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Takes them out again. Every function throws ReadError when the bytes end too early.
class StateReader {
 public:
  /// `name` is for messages.
  StateReader(std::string_view bytes, std::string name) : rest_(bytes), name_(std::move(name)) {}

  template <typename T>
  T value() {
    static_assert(std::is_arithmetic_v<T>);
    need(sizeof(T));
    T v;
    std::memcpy(&v, rest_.data(), sizeof v);
    rest_.remove_prefix(sizeof v);
    return v;
  }
  std::string text(std::size_t most) {
    const auto size = value<std::uint32_t>();
    if (size > most) refuse("a text is too long");
    need(size);
    std::string t(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return t;
  }
  std::uint64_t number() {
    std::uint64_t v = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      const auto byte = value<std::uint8_t>();
      v |= static_cast<std::uint64_t>(byte & 0x7fU) << shift;
      if (byte < 0x80) return v;
    }
    refuse("a number is too large");
  }
  std::int64_t difference() {
    const std::uint64_t v = number();
    return static_cast<std::int64_t>(v >> 1U) ^ -static_cast<std::int64_t>(v & 1U);
  }
  /// How many things follow, each of at least `least` bytes: never more than there are bytes for.
  std::size_t count(std::size_t least) {
    const std::uint64_t n = number();
    if (n > rest_.size() / least) refuse("it ends too early");
    return static_cast<std::size_t>(n);
  }
  bool at_end() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

  [[noreturn]] void refuse(const std::string& what) const {
    throw ReadError(name_ + ": is broken (" + what + "); run 'regarment fit' again");
  }

 private:
  void need(std::size_t bytes) const {
    if (rest_.size() < bytes) refuse("it ends too early");
  }

  std::string_view rest_;
  std::string name_;
};

}  // namespace regarment
