#include <gtest/gtest.h>

#include "geometry/read_text.h"

namespace regarment::test {
namespace {

Mesh read_obj_text(const std::string& file) { return read_text(file, MeshFormat::Obj); }

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const Corners kSquareFan{{0, 1, 2}, {0, 2, 3}};

TEST(ObjReader, VerticesKeepTheirOrderAlsoWhenNoFaceUsesThem) {
  const Mesh mesh = read_obj_text("v 9 9 9\n" + kSquare + "v 8 8 8\nf 4 3 2\n");
  EXPECT_EQ(mesh.positions,
            (std::vector<Vec3>{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {8, 8, 8}}));
  EXPECT_EQ(mesh.triangles, (Corners{{3, 2, 1}}));
}

TEST(ObjReader, EveryFormOfACorner) {
  const std::string rest = "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n";
  for (const char* face :
       {"f 1 2 3 4", "f 1/1 2/2 3/3 4/1", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/1 4/1/1",
        "f -4 -3 -2 -1", "f -4/-1 -3/-2 -2/-3 -1/-1", "f -4//-1 -3//-1 -2//-1 -1//-1",
        "f\t1  2\t3 4  "}) {
    EXPECT_EQ(read_obj_text(kSquare + rest + face).triangles, kSquareFan) << face;
  }
}

TEST(ObjReader, NegativeIndicesCountBackFromWhereTheyStand) {
  EXPECT_EQ(read_obj_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -3 -2 -1\n").triangles,
            (Corners{{0, 1, 2}, {1, 2, 3}}));
}

TEST(ObjReader, FacesMayNameVerticesThatFollow) {
  EXPECT_EQ(read_obj_text("f 1 2 3\n" + kSquare).triangles, (Corners{{0, 1, 2}}));
}

TEST(ObjReader, ColoursAfterTheCoordinates) {
  EXPECT_EQ(read_obj_text("v 0 0 0 1 0 0.2\nv 1 0 0 0 1 0\n").colours,
            (std::vector<Colour>{{255, 0, 51}, {0, 255, 0}}));
  EXPECT_EQ(read_obj_text("v 0 0 0 1 0 1 0\n").colours, (std::vector<Colour>{{0, 255, 0}}))
      << "the weight stands before the colour";
  EXPECT_TRUE(read_obj_text("v 0 0 0 1 0 0.2\nv 1 0 0\n").colours.empty()) << "one has none";
}

TEST(ObjReader, NormalsWhenEachVertexHasItsOwn) {
  const std::string normals = "vn 0 0 2\nvn 0 1 0\nvn 1 0 0\nvn 0 0 -1\n";
  const std::vector<Vec3> unit{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  EXPECT_EQ(read_obj_text(kSquare + normals + "f 1//1 2//2 3//3\n").normals, unit);
  EXPECT_EQ(read_obj_text(kSquare + normals).normals, unit) << "a cloud";
  EXPECT_TRUE(read_obj_text(kSquare + normals + "f 1//2 2//2 3//3\n").normals.empty());
  EXPECT_TRUE(read_obj_text(kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\n").normals.empty());
}

TEST(ObjReader, StatementsGoOnAfterABackslash) {
  EXPECT_EQ(read_obj_text(kSquare + "f 1 2 \\\n3 \\\r\n 4\n").triangles, kSquareFan);
  EXPECT_EQ(read_obj_text("# C:\\scans\\\n" + kSquare + "f 1 2 3 4").triangles, kSquareFan)
      << "a path in a comment ends with a backslash";
  EXPECT_EQ(read_obj_text(kSquare + "f 1 2 3 4 \\").triangles, kSquareFan) << "at the end";
}

TEST(ObjReader, PassesOverWhatMakesNoSurface) {
  const std::string others =
      "# comment\nmtllib /etc/passwd\no thing\ng a b\ns off\nusemtl red\nvt 0 0\nvp 1 2\n"
      "p 1 2\nl 1 2 3\n\n   \n";
  const Mesh mesh = read_obj_text(others + kSquare + others + "f 1 2 3 4\n" + others);
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.triangles, kSquareFan);
}

TEST(ObjReader, WindowsLineEnds) {
  EXPECT_EQ(read_obj_text("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n").triangles,
            (Corners{{0, 1, 2}}));
}

}  // namespace
}  // namespace regarment::test
