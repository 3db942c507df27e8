#include "support/bad_files.h"

#include <sys/stat.h>

#include <fstream>
#include <stdexcept>

namespace regarment::test {
void add_files_of_another_kind(std::vector<BadFile>& files) {
  const auto add = [&](const char* title, std::string name, const char* says, std::string bytes) {
    files.push_back({title, std::move(name), [bytes = std::move(bytes)] { return bytes; }, says});
  };
  using namespace std::string_literals;
  add("empty file", "scan.ply", "the file is empty", "");
  add("empty file without a known name", "scan", "the file is empty", "");
  add("gzip", "scan.ply", "compressed with gzip", "\x1f\x8b\x08\x00rest"s);
  add("zip", "scan.obj", "is a zip archive", "PK\x03\x04rest");
  add("UTF-16", "scan.obj", "is UTF-16 text", "\xff\xfev\0 \0"s);
  add("UTF-16 of the other order", "scan.obj", "is UTF-16 text", "\xfe\xff\0v"s);
  add("byte order mark", "scan.ply", "begins with a byte order mark",
      "\xef\xbb\xbfply\nformat ascii 1.0\n");
  add("picture", "scan.ply", "is a picture", "\x89PNG\r\n\x1a\n");
  add("MD5 model named PLY", "scan.ply", "does not begin like one",
      "MD5Version 10\ncommandline \"\"\n");
  add("OFF named PLY", "scan.ply", "named as PLY but holds OFF; rename it to .off",
      "OFF\n1 0 0\n0 0 0\n");
  add("PLY named STL", "scan.stl", "named as STL but holds PLY", "ply\nformat ascii 1.0\n");
  add("Collada", "scan.dae", "tells a known format",
      "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b SYSTEM \"file:///etc/passwd\">]><COLLADA/>");
  add("text without a known name", "notes.txt", "tells a known format", "nothing to see\n");
  add("blanks in the name", "my scan (1).txt", "my scan (1).txt: ", "x");
  add("line feed and escape in the name", "two\nlines\x1b[2J.ply",
      "two\\x0alines\\x1b[2J.ply: ", "x");
  add("markup in the name", "<script>alert(1).ply", "<script>alert(1).ply: ", "x");
  add("name of 250 letters", std::string(246, 'n') + ".ply", ": byte 0: ", "x");

  using Kind = BadFile::Kind;
  const auto special = [&](const char* title, const char* says, Kind kind) {
    files.push_back({title, "scan.ply", [] { return std::string(); }, says, kind});
  };
  special("missing file", "cannot be opened (No such file or directory)", Kind::Missing);
  special("directory", "is a directory, not a file", Kind::Directory);
  special("pipe without a writer", "is a pipe, not a file", Kind::Fifo);
  special("socket", "cannot be opened", Kind::Socket);
  special("link to itself", "cannot be opened", Kind::LinkToItself);
}

std::vector<BadFile> bad_files() {
  std::vector<BadFile> files;
  add_files_of_another_kind(files);
  add_bad_ply_headers(files);
  add_bad_ply_bodies(files);
  add_bad_text_meshes(files);
  add_bad_other_meshes(files);
  return files;
}

std::filesystem::path put(const BadFile& file, const std::filesystem::path& folder) {
  std::filesystem::path path = folder / file.file_name;
  switch (file.kind) {
    case BadFile::Kind::Missing:
      break;
    case BadFile::Kind::Directory:
      std::filesystem::create_directory(path);
      break;
    case BadFile::Kind::Fifo:
      if (mkfifo(path.c_str(), 0600) != 0) throw std::runtime_error("no pipe at " + path.string());
      break;
    case BadFile::Kind::Socket:
      if (mknod(path.c_str(), S_IFSOCK | 0600, 0) != 0) {
        throw std::runtime_error("no socket at " + path.string());
      }
      break;
    case BadFile::Kind::LinkToItself:
      std::filesystem::create_symlink(path.filename(), path);
      break;
    case BadFile::Kind::Bytes: {
      const std::string bytes = file.bytes();
      std::ofstream out(path, std::ios::binary);
      out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
    }
  }
  return path;
}

}  // namespace regarment::test
