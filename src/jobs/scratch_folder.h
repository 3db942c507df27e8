#pragma once

#include <filesystem>

namespace regarment {

/// A folder of this process alone, below one that several may share. It is removed with this; what
/// processes that were killed left there goes when the next one begins.
class ScratchFolder {
 public:
  /// Makes `parent`, readable to its owner only, and the folder in it. Throws UsageError when that
  /// may not be, TemporaryError when the disk is full.
  explicit ScratchFolder(const std::filesystem::path& parent);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  // its descriptor, locked as long as its owner lives
};

}  // namespace regarment
