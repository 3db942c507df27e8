#include "report/content_policy.h"

#include <charconv>

#include "base/sha256.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string hash_source(std::string_view text) {
  const std::string hex = sha256_hex(std::as_bytes(std::span(text)));
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    unsigned value = 0;
    std::from_chars(hex.data() + i, hex.data() + i + 2, value, 16);
    bytes += static_cast<char>(value);
  }
  return "'sha256-" + base64(bytes) + "'";
}

}  // namespace

std::string content_policy(std::string_view style, std::string_view script) {
  return "default-src 'none'; img-src data:; style-src " + hash_source(style) + "; script-src " +
         hash_source(script) + "; base-uri 'none'; form-action 'none'";
}

}  // namespace regarment
