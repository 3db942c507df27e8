#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace regarment {

/// A folder that appears whole or not at all: files go into a hidden sibling, which takes the
/// folder's place in one step. Destroyed without `publish`, it leaves nothing behind.
class OutputFolder {
 public:
  /// `place` may not exist (missing parents are made), be an empty folder, or, with `replace`, be
  /// any folder that is no root and holds neither the working directory nor any of `inputs`. Throws
  /// UsageError when it may not be written there, TemporaryError when the disk is full.
  OutputFolder(const std::filesystem::path& place, bool replace,
               const std::vector<std::filesystem::path>& inputs = {});
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes one file; `name` may lie in a subfolder ("pictures/scan-front.jpg"). Throws as
  /// `write_file` does.
  void write(const std::filesystem::path& name, std::string_view bytes);

  /// Where the files stand until `publish`.
  const std::filesystem::path& hidden() const { return hidden_; }

  /// Puts the folder in its place; a full one there is exchanged in one step and then removed.
  void publish();

 private:
  void make_parents(const std::filesystem::path& parent);
  void remove_parents();
  void exchange();

  std::filesystem::path place_;              // absolute, no symbolic link at its end
  std::filesystem::path hidden_;             // sibling of place_; empty once published
  std::vector<std::filesystem::path> made_;  // parents made here, outermost first
  bool replace_;
};

/// Tries the constructor of OutputFolder and leaves nothing: a place that will not do is told
/// before the work begins.
void check_output_folder(const std::filesystem::path& place, bool replace,
                         const std::vector<std::filesystem::path>& inputs = {});

}  // namespace regarment
