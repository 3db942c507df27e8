#include <gtest/gtest.h>

#include "geometry/read_text.h"

namespace regarment::test {
namespace {

Mesh read_off_text(const std::string& file) { return read_text(file, MeshFormat::Off); }

const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const Corners kSquareFan{{0, 1, 2}, {0, 2, 3}};

TEST(OffReader, CountsOnTheirOwnLineOrBesideTheWord) {
  for (const char* head : {"OFF\n4 1 0\n", "OFF 4 1 0\n", "OFF\n# made by hand\n\n4 1 5 # counts\n",
                           "OFF\r\n4 1 0\r\n", "OFF\n4 1\n"}) {
    const Mesh mesh = read_off_text(head + kSquare + "4 0 1 2 3\n");
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, kSquareFan) << head;
  }
}

TEST(OffReader, CloudWithoutFaces) {
  const Mesh mesh = read_off_text("OFF\n4 0 0\n" + kSquare);
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_TRUE(mesh.is_cloud());
}

TEST(OffReader, ColoursAsBytesOrFractions) {
  const std::vector<Colour> expected{{255, 0, 51}, {0, 102, 0}};
  EXPECT_EQ(read_off_text("COFF\n2 0 0\n0 0 0 255 0 51 255\n1 0 0 0 102 0 255\n").colours,
            expected);
  EXPECT_EQ(read_off_text("COFF\n2 0 0\n0 0 0 255 0 51\n1 0 0 0 102 0\n").colours, expected);
  EXPECT_EQ(read_off_text("COFF\n2 0 0\n0 0 0 1 0 .2 1\n1 0 0 0 .4 0 1\n").colours, expected);
}

TEST(OffReader, Normals) {
  EXPECT_EQ(read_off_text("NOFF\n2 0 0\n0 0 0 0 0 3\n1 0 0 0 0 0\n").normals,
            (std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}}));
}

TEST(OffReader, TextureCoordinatesArePassedOver) {
  EXPECT_EQ(read_off_text("STOFF\n1 0 0\n1 2 3 0.5 0.5\n").positions.at(0), Vec3(1, 2, 3));
  const Mesh mesh = read_off_text("STCOFF\n1 0 0\n1 2 3 9 8 7 255 0.5 0.5\n");
  EXPECT_EQ(mesh.colours.at(0), (Colour{9, 8, 7}));
}

// Exporters disagree on which comes first, so neither may be guessed.
TEST(OffReader, NormalsAndColoursTogetherAreLeftOut) {
  const Mesh mesh = read_off_text("CNOFF\n1 0 0\n1 2 3 0 0 1 9 8 7 255\n");
  EXPECT_EQ(mesh.positions.at(0), Vec3(1, 2, 3));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.colours.empty());
}

TEST(OffReader, ColoursOfFacesArePassedOver) {
  const Mesh mesh = read_off_text("OFF\n4 3 0\n" + kSquare +
                                  "4 0 1 2 3 255 0 0\n3 2 1 0 0.5 0.5 0.5 1\n2 0 1\n# end\n");
  EXPECT_EQ(mesh.triangles, (Corners{{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}));
}

}  // namespace
}  // namespace regarment::test
