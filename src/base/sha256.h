#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace regarment {

/// SHA-256 (FIPS 180-4) of bytes that may come in pieces.
/// `Sha256 sha; sha.add(a); sha.add(b); sha.hex()` equals `sha256_hex` of a followed by b.
class Sha256 {
 public:
  void add(std::span<const std::byte> bytes);
  /// The digest of everything added so far, 64 lower-case hexadecimal digits.
  std::string hex() const;

 private:
  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::byte, 64> open_{};  // the block not yet full
  std::uint64_t added_ = 0;           // bytes
};

std::string sha256_hex(std::span<const std::byte> bytes);

}  // namespace regarment
