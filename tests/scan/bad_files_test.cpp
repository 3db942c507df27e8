#include "support/bad_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <set>

#include "base/error.h"
#include "scan/read_sandboxed.h"
#include "support/folders.h"
#include "support/gltf_maker.h"
#include "support/mutate.h"

namespace regarment::test {
namespace {

TEST(BadFiles, AreSixtyAtLeastAndHaveTitlesOfTheirOwn) {
  std::set<std::string> titles;
  for (const BadFile& file : bad_files()) titles.insert(file.title);
  EXPECT_EQ(titles.size(), bad_files().size());
  EXPECT_GE(titles.size(), 60U);
}

TEST(BadFiles, EachGivesOneLineThatSaysWhat) {
  for (const BadFile& file : bad_files()) {
    SCOPED_TRACE(file.title);
    const TemporaryFolder folder;
    try {
      read_mesh_sandboxed(put(file, folder.path()));
      ADD_FAILURE() << "it was read";
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.exit_status(), file.exit_status);
      EXPECT_NE(message.find(file.says), std::string::npos) << message;
      for (const char c : message) {
        EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 || c == 0x7f) << message;
      }
      EXPECT_LT(message.size(), 700U) << message;
    }
  }
  struct rusage children {};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &children), 0);
  EXPECT_LT(children.ru_maxrss, 1L << 20U) << "KiB, the promise of 1 GiB";
}

// glTF goes through a library that is not ours, so its mutants are read in the sandbox only.
TEST(BadFiles, MutantsOfGltfAreRefusedOrValid) {
  GltfMaker maker;
  maker.mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
  maker.node("\"mesh\":0,\"translation\":[1,2,3]").node("\"children\":[0]");
  std::mt19937 random(7);
  int read = 0;
  constexpr int kFiles = 400;
  for (int i = 0; i < kFiles; ++i) {
    const bool binary = i % 2 == 0;
    const TemporaryFolder folder;
    const auto path = folder.path() / (binary ? "scan.glb" : "scan.gltf");
    std::ofstream(path, std::ios::binary)
        << mutate(binary ? maker.glb("1") : maker.gltf("1"), random);
    try {
      const Mesh mesh = read_mesh_sandboxed(path).mesh;
      ++read;
      for (const Vec3& p : mesh.positions) ASSERT_TRUE(p.allFinite()) << i;
      for (const Triangle& t : mesh.triangles) {
        ASSERT_LT(*std::max_element(t.begin(), t.end()), mesh.positions.size()) << i;
      }
    } catch (const ReadError&) {
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, kFiles);
}

}  // namespace
}  // namespace regarment::test
