#include "base/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <new>

#include "base/error.h"

namespace regarment {
namespace {

void check(int done) {
  if (done != 1)
    throw Error(1,
                "SHA-256: the machine's OpenSSL refuses it; see its openssl.cnf, or OPENSSL_CONF");
}

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* state) const { EVP_MD_CTX_free(state); }

Sha256::State Sha256::new_state() {
  State state(EVP_MD_CTX_new());
  if (!state) throw std::bad_alloc();
  return state;
}

Sha256::Sha256() { check(EVP_DigestInit_ex(state_.get(), EVP_sha256(), nullptr)); }

void Sha256::add(std::span<const std::byte> bytes) {
  check(EVP_DigestUpdate(state_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::hex() const {
  const State last = new_state();
  check(EVP_MD_CTX_copy_ex(last.get(), state_.get()));
  std::array<unsigned char, 32> digest{};
  check(EVP_DigestFinal_ex(last.get(), digest.data(), nullptr));
  std::string text;
  for (const unsigned byte : digest) {
    text += "0123456789abcdef"[byte >> 4U];
    text += "0123456789abcdef"[byte & 15U];
  }
  return text;
}

std::string sha256_hex(std::span<const std::byte> bytes) {
  Sha256 sha;
  sha.add(bytes);
  return sha.hex();
}

}  // namespace regarment
