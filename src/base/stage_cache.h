#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace regarment {

/// Results of stages in a folder, each under a name made from everything it depends on, so that
/// none is ever out of date. Any number of processes may use one folder at once: entries appear
/// whole, and one that is taken away meanwhile is a miss. What is read back is only as trustworthy
/// as the folder; who reads it checks its form.
class StageCache {
 public:
  /// The folder is made where it is missing. Keeps at most `most_bytes`, those used last. Throws
  /// UsageError when it is no folder, or cannot be made or written to.
  StageCache(std::filesystem::path folder, std::uint64_t most_bytes);

  /// The entry put under this name, if it is still there; it counts as used now.
  std::optional<std::string> get(const std::string& name) const;

  /// Keeps the bytes under this name, which has letters, digits, '.' and '-' alone. An entry of
  /// more than `most_bytes` is not kept, nor is any when the disk is full: a cache may forget.
  void put(const std::string& name, std::string_view bytes) const;

 private:
  void shrink() const;

  std::filesystem::path folder_;
  std::uint64_t most_bytes_;
};

/// What tells this program from every other build of it; empty when it does not know. Part of the
/// name of an entry, since another build may come to other results.
std::string build_identity();

}  // namespace regarment
