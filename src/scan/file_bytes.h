#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

namespace regarment {

/// The content of a file, held in memory.
struct FileBytes {
  std::unique_ptr<std::byte[]> data;
  std::size_t size = 0;

  std::span<const std::byte> span() const { return {data.get(), size}; }
};

/// Reads a regular file of at most `most` bytes. Never waits on pipes or devices. Throws ReadError
/// when the file is missing, not readable, not a regular file or too large, saying how large.
FileBytes read_file_bytes(const std::filesystem::path& path, std::uintmax_t most);

}  // namespace regarment
