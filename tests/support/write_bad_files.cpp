// Writes every bad file that is a plain file into a folder, one a folder numbered from 0, for tests
// in other languages:  write_bad_files FOLDER
#include <filesystem>
#include <string>

#include "bad_files.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  int number = 0;
  for (const auto& file : regarment::test::bad_files()) {
    if (file.kind != regarment::test::BadFile::Kind::Bytes) continue;
    const auto folder = std::filesystem::path(argv[1]) / std::to_string(number++);
    std::filesystem::create_directories(folder);
    regarment::test::put(file, folder);
  }
  return 0;
}
