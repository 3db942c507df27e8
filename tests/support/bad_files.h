#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace regarment::test {

/// A file that is no scan, and what a person must be told about it. Made when asked for, never
/// stored. The reader and the command line are tested against the same list.
struct BadFile {
  enum class Kind { Bytes, Missing, Directory, Fifo, Socket, LinkToItself };

  std::string title;                   // unique, what is wrong, in words
  std::string file_name;               // may hold blanks and control characters
  std::function<std::string()> bytes;  // of Kind::Bytes
  std::string says;                    // part of the one line of the message
  Kind kind = Kind::Bytes;
  int exit_status = 3;
};

/// Every bad file known, at least 60.
std::vector<BadFile> bad_files();

/// Puts the file into `folder` (which must exist) and returns its path.
std::filesystem::path put(const BadFile& file, const std::filesystem::path& folder);

// The parts of the list.
void add_bad_ply_headers(std::vector<BadFile>& files);
void add_bad_ply_bodies(std::vector<BadFile>& files);
void add_bad_text_meshes(std::vector<BadFile>& files);   // OBJ and OFF
void add_bad_other_meshes(std::vector<BadFile>& files);  // STL and glTF
void add_files_of_another_kind(std::vector<BadFile>& files);

}  // namespace regarment::test
