#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace regarment {

/// The folder of an evaluation: fits/NAME per scan, and the files made of them. One program at a
/// time works in it.
class EvaluationFolder {
 public:
  /// `place` may not exist (missing parents are made), be empty, or hold an earlier evaluation,
  /// whose fits are kept. Half-written fits of an interrupted one are removed. Throws UsageError
  /// when something else stands there, it is not writable, or another program works in it;
  /// TemporaryError when the disk is full.
  explicit EvaluationFolder(std::filesystem::path place);
  ~EvaluationFolder();
  EvaluationFolder(const EvaluationFolder&) = delete;
  EvaluationFolder& operator=(const EvaluationFolder&) = delete;

  const std::filesystem::path& place() const { return place_; }
  std::filesystem::path fits() const { return place_ / "fits"; }

  /// Writes a file in one step: it is there whole or as it was before.
  void write(const std::string& name, std::string_view bytes) const;

 private:
  std::filesystem::path place_;
  int lock_ = -1;  // descriptor of the folder, locked while this lives
};

}  // namespace regarment
