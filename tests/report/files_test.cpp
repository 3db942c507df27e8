#include "report/files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/sha256.h"
#include "support/folders.h"

namespace regarment {
namespace {

TEST(FileSha256, IsThatOfTheBytes) {
  const TemporaryFolder home;
  const std::string text(200'000, 'r');
  std::ofstream(home.path() / "f") << text;
  EXPECT_EQ(file_sha256(home.path() / "f"), sha256_hex(std::as_bytes(std::span(text))));
  EXPECT_EQ(file_sha256(home.path() / "none"), "");
}

}  // namespace
}  // namespace regarment
