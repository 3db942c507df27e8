#include <gtest/gtest.h>

#include "geometry/read_text.h"
#include "support/gltf_maker.h"

namespace regarment::test {
namespace {

using Points = std::vector<std::array<float, 3>>;
// The last vertex belongs to no triangle and must survive.
const Points kTriangleAndMore{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 8, 9}};

TEST(GltfReader, EmbeddedBufferAndBinaryFile) {
  GltfMaker maker;
  maker.mesh(kTriangleAndMore, {2, 0, 1});
  maker.node("\"mesh\":0");
  for (const Mesh& mesh :
       {read_text(maker.gltf("0"), MeshFormat::Gltf), read_text(maker.glb("0"), MeshFormat::Glb)}) {
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 8, 9}}));
    EXPECT_EQ(mesh.triangles, (Corners{{2, 0, 1}}));
  }
}

TEST(GltfReader, PointsAreACloud) {
  GltfMaker maker;
  maker.mesh(kTriangleAndMore, {});
  maker.node("\"mesh\":0");
  const Mesh mesh = read_text(maker.glb("0"), MeshFormat::Glb);
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_TRUE(mesh.is_cloud());
}

TEST(GltfReader, NodesDepthFirstAndMovedByTheirParents) {
  GltfMaker maker;
  maker.mesh({{1, 0, 0}}, {});
  maker.mesh({{0, 1, 0}}, {});
  maker.node("\"mesh\":0,\"translation\":[10,0,0]");                  // 0
  maker.node("\"children\":[3,0],\"translation\":[0,0,5]");           // 1
  maker.node("\"mesh\":1,\"scale\":[2,2,2]");                         // 2
  maker.node("\"mesh\":1,\"rotation\":[0,0,0.70710678,0.70710678]");  // 3: 90 degrees about z
  const Mesh mesh = read_text(maker.glb("2,1"), MeshFormat::Glb);
  const std::vector<Vec3> expected{{0, 2, 0}, {-1, 0, 5}, {11, 0, 5}};
  ASSERT_EQ(mesh.positions.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((mesh.positions[i] - expected[i]).norm(), 1e-6) << i;  // m, floats in the file
  }
}

TEST(GltfReader, TwoPartsKeepTheirOwnIndices) {
  GltfMaker maker;
  maker.mesh(kTriangleAndMore, {0, 1, 2});
  maker.mesh(kTriangleAndMore, {2, 1, 0});
  maker.node("\"mesh\":1").node("\"mesh\":0");
  EXPECT_EQ(read_text(maker.gltf("0,1"), MeshFormat::Gltf).triangles,
            (Corners{{2, 1, 0}, {4, 5, 6}}));
}

// A mirrored part would otherwise show its inside.
TEST(GltfReader, MirroringNodesTurnFacesRound) {
  GltfMaker maker;
  maker.mesh(kTriangleAndMore, {0, 1, 2});
  maker.node("\"mesh\":0,\"scale\":[-1,1,1]");
  const Mesh mesh = read_text(maker.glb("0"), MeshFormat::Glb);
  const Triangle& t = mesh.triangles.at(0);
  const Vec3 normal = (mesh.positions[t[1]] - mesh.positions[t[0]])
                          .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
  EXPECT_GT(normal.z(), 0);
}

TEST(GltfReader, TransformsToAbsurdDistancesAreRefused) {
  GltfMaker maker;
  maker.mesh(kTriangleAndMore, {0, 1, 2});
  maker.node("\"mesh\":0,\"scale\":[1e38,1e38,1e38],\"translation\":[3e38,0,0]");
  EXPECT_EQ(complaint(maker.glb("0"), MeshFormat::Glb).substr(0, 17), "test file: part 1");
}

TEST(GltfReader, AWordOfCompressionInANameIsNoCompression) {
  GltfMaker maker;
  maker.mesh(kTriangleAndMore, {0, 1, 2});
  maker.node("\"mesh\":0,\"name\":\"no KHR_draco here\"");
  EXPECT_EQ(complaint(maker.glb("0"), MeshFormat::Glb), "");
}

TEST(GltfReader, ListsStripsAndFansOfTriangles) {
  GltfMaker maker;
  maker.mesh(kTriangleAndMore, {});
  maker.node("\"mesh\":0");
  const std::string points = maker.gltf("0");
  const auto with_mode = [&](char mode) {
    std::string file = points;
    file[file.find("\"mode\":0") + 7] = mode;
    return read_text(file, MeshFormat::Gltf).triangles;
  };
  EXPECT_EQ(with_mode('4'), (Corners{{0, 1, 2}}));
  EXPECT_EQ(with_mode('5'), (Corners{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(with_mode('6'), (Corners{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(with_mode('1'), Corners()) << "lines";
}

}  // namespace
}  // namespace regarment::test
