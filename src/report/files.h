#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace regarment {

/// The bytes of a regular file, at most `max_bytes` of them: a longer file gives `max_bytes`, which
/// callers that care notice by asking for one more than they take. Throws ReadError when there is
/// no such file, it is a folder or a device, or may not be read.
std::string read_file(const std::filesystem::path& file, std::size_t max_bytes);

/// Writes a new file. Throws TemporaryError when the disk is full, UsageError when the place is not
/// writable.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Writes a file in one step, by way of a hidden one beside it: it is there whole or as it was
/// before. One writer at a time. Throws as `write_file` does.
void replace_file(const std::filesystem::path& file, std::string_view bytes);

/// SHA-256 of a file, hexadecimal; empty when it cannot be read.
std::string file_sha256(const std::filesystem::path& file);

/// Throws what `write_file` throws for this `errno`, about `file`.
[[noreturn]] void throw_write_error(const std::filesystem::path& file, int error);

}  // namespace regarment
