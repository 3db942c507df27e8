#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace regarment {

/// The eight words that SHA-256 carries from block to block.
using ShaState = std::array<std::uint32_t, 8>;

/// Takes in `blocks` times 64 bytes, in the way that is quickest on this processor.
void add_blocks(const std::byte* data, std::size_t blocks, ShaState& state);

/// The same by FIPS 180-4, 6.2.2, as written there.
void add_blocks_plainly(const std::byte* data, std::size_t blocks, ShaState& state);

}  // namespace regarment
