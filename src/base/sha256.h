#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

struct evp_md_ctx_st;  // OpenSSL's

namespace regarment {

/// SHA-256 (FIPS 180-4) of bytes that may come in pieces.
/// `Sha256 sha; sha.add(a); sha.add(b); sha.hex()` equals `sha256_hex` of a followed by b.
/// Movable; one that was moved from may only be assigned to or destroyed. Throws std::bad_alloc,
/// or Error where the machine's OpenSSL is set up to know no SHA-256.
class Sha256 {
 public:
  Sha256();
  void add(std::span<const std::byte> bytes);
  /// The digest of everything added so far, 64 lower-case hexadecimal digits. More may follow.
  std::string hex() const;

 private:
  struct Free {
    void operator()(evp_md_ctx_st* state) const;
  };
  using State = std::unique_ptr<evp_md_ctx_st, Free>;

  static State new_state();

  State state_ = new_state();
};

std::string sha256_hex(std::span<const std::byte> bytes);

}  // namespace regarment
