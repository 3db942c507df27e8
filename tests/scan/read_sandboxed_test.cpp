#include "scan/read_sandboxed.h"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "base/error.h"
#include "base/sha256.h"
#include "geometry/ply_writer.h"
#include "support/folders.h"
#include "support/gltf_maker.h"
#include "support/stl_maker.h"

namespace regarment::test {
namespace {

const std::vector<Vec3> kPoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 8, 9}};
const std::vector<Triangle> kTriangle{{0, 1, 2}};

class ReadSandboxed : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << bytes;
    return folder_.path() / name;
  }
  static std::string ply() { return PlyWriter(4).positions(kPoints).triangles(kTriangle).bytes(); }

  TemporaryFolder folder_;
};

TEST_F(ReadSandboxed, EveryFormat) {
  GltfMaker gltf;
  gltf.mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 8, 9}}, {0, 1, 2});
  gltf.node("\"mesh\":0");
  struct Case {
    const char* name;
    MeshFormat format;
    std::string bytes;
  };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n7 8 9\n";
  for (const Case& c : {Case{"a.ply", MeshFormat::Ply, ply()},
                        {"a.obj", MeshFormat::Obj,
                         "mtllib /etc/passwd\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 7 8 9\nf 1 2 3\n"},
                        {"a.off", MeshFormat::Off, "OFF\n4 1 0\n" + points + "3 0 1 2\n"},
                        {"a.glb", MeshFormat::Glb, gltf.glb("0")},
                        {"a.gltf", MeshFormat::Gltf, gltf.gltf("0")}}) {
    SCOPED_TRACE(c.name);
    const ReadMesh read = read_mesh_sandboxed(write(c.name, c.bytes));
    EXPECT_EQ(read.format, c.format);
    EXPECT_EQ(read.mesh.positions, kPoints);
    EXPECT_EQ(read.mesh.triangles, kTriangle);
    EXPECT_EQ(read.sha256, sha256_hex(std::as_bytes(std::span(c.bytes))));
  }
  const Facet facet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const ReadMesh stl = read_mesh_sandboxed(write("a.stl", binary_stl({facet, facet})));
  EXPECT_EQ(stl.format, MeshFormat::Stl);
  EXPECT_EQ(stl.mesh.positions.size(), 6U);
}

TEST_F(ReadSandboxed, NormalsAndColoursComeThrough) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  const Mesh mesh =
      read_mesh_sandboxed(write("a.ply", head + "0 0 0 0 0 1 1 2 3\n1 1 1 0 2 0 4 5 6\n")).mesh;
  EXPECT_EQ(mesh.normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(mesh.colours, (std::vector<Colour>{{1, 2, 3}, {4, 5, 6}}));
}

// More than the 256 MiB of shared memory and of address space that small files get.
TEST_F(ReadSandboxed, LargeFilesGetMemoryByTheirSize) {
  constexpr std::size_t kVertices = 6'000'000;
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(kVertices) +
                     "\nproperty char x\nproperty char y\nproperty char z\nproperty char nx\n"
                     "property char ny\nproperty char nz\nend_header\n";
  file.append(6 * kVertices, '\1');
  const Mesh mesh = read_mesh_sandboxed(write("large.ply", file)).mesh;
  EXPECT_EQ(mesh.positions.size(), kVertices);
  EXPECT_EQ(mesh.positions.back(), Vec3(1, 1, 1));
  EXPECT_EQ(mesh.normals.size(), kVertices);
}

TEST_F(ReadSandboxed, FilesLargerThanAllowedAreRefusedWithTheirSize) {
  ReadLimits limits;
  limits.file_bytes = ply().size() - 1;
  try {
    read_mesh_sandboxed(write("a.ply", ply()), limits);
    FAIL();
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("has " + std::to_string(ply().size()) + " bytes"),
              std::string::npos)
        << error.what();
  }
  limits.file_bytes = ply().size();
  EXPECT_EQ(read_mesh_sandboxed(write("a.ply", ply()), limits).mesh.positions, kPoints);
}

TEST_F(ReadSandboxed, LimitsOnVerticesHold) {
  ReadLimits limits;
  limits.mesh.max_vertices = 3;
  EXPECT_THROW(read_mesh_sandboxed(write("a.ply", ply()), limits), ReadError);
}

TEST_F(ReadSandboxed, OddNamesAreReadLikeAnyOther) {
  for (const char* name : {"two words.ply", "line\nfeed.ply", "-rf.ply", "caf\xc3\xa9.PLY"}) {
    EXPECT_EQ(read_mesh_sandboxed(write(name, ply())).mesh.positions, kPoints) << name;
  }
}

TEST_F(ReadSandboxed, TellsProgressAndStops) {
  const auto path = write("a.ply", ply());
  std::vector<double> told;
  read_mesh_sandboxed(path, {}, Progress([&](std::string_view, double fraction) {
                        told.push_back(fraction);
                        return true;
                      }));
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_THROW(
      read_mesh_sandboxed(path, {}, Progress([](std::string_view, double) { return false; })),
      Stopped);
}

TEST_F(ReadSandboxed, SeveralThreadsAtOnce) {
  const auto path = write("a.ply", ply());
  std::vector<int> right(4, 0);
  std::vector<std::thread> threads;
  for (int& count : right) {
    threads.emplace_back([&path, &count] {
      for (int i = 0; i < 10; ++i) count += read_mesh_sandboxed(path).mesh.positions == kPoints;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, (std::vector<int>{10, 10, 10, 10}));
}

}  // namespace
}  // namespace regarment::test
