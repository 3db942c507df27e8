#include "base/sha256.h"

#include <algorithm>

#include "base/sha256_blocks.h"

namespace regarment {

void Sha256::add(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const std::size_t filled = added_ % open_.size();
    if (filled == 0 && bytes.size() >= open_.size()) {
      const std::size_t blocks = bytes.size() / open_.size();
      add_blocks(bytes.data(), blocks, state_);
      added_ += blocks * open_.size();
      bytes = bytes.subspan(blocks * open_.size());
      continue;
    }
    const std::size_t taken = std::min(open_.size() - filled, bytes.size());
    std::copy_n(bytes.begin(), taken, open_.begin() + static_cast<std::ptrdiff_t>(filled));
    added_ += taken;
    bytes = bytes.subspan(taken);
    if (filled + taken == open_.size()) add_blocks(open_.data(), 1, state_);
  }
}

std::string Sha256::hex() const {
  Sha256 last = *this;
  // A one bit, zeros, and the length in bits fill the last block.
  std::array<std::byte, 72> padding{std::byte{0x80}};
  const std::size_t zeros_end = (119 - added_ % 64) % 64 + 1;
  for (std::size_t i = 0; i < 8; ++i) {
    padding[zeros_end + i] = static_cast<std::byte>(added_ * 8 >> (56 - 8 * i));
  }
  last.add(std::span(padding).first(zeros_end + 8));
  std::string text;
  for (const std::uint32_t word : last.state_) {
    for (int shift = 28; shift >= 0; shift -= 4) {
      text += "0123456789abcdef"[word >> static_cast<unsigned>(shift) & 15U];
    }
  }
  return text;
}

std::string sha256_hex(std::span<const std::byte> bytes) {
  Sha256 sha;
  sha.add(bytes);
  return sha.hex();
}

}  // namespace regarment
