#include <gtest/gtest.h>

#include "geometry/read_text.h"
#include "support/stl_maker.h"

namespace regarment::test {
namespace {

// Two triangles that share an edge: a reader that joins vertices would give four.
const std::vector<Facet> kTwoFacets{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}},
                                    {{{0, 0, 0}, {1, 1, 0}, {0, 1, 0.5}}}};

TEST(StlReader, ThreeVerticesPerFacetInTheFilesOrder) {
  for (const std::string& file : {binary_stl(kTwoFacets), text_stl(kTwoFacets)}) {
    const Mesh mesh = read_text(file, MeshFormat::Stl);
    EXPECT_EQ(
        mesh.positions,
        (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0.5}}));
    EXPECT_EQ(mesh.triangles, (Corners{{0, 1, 2}, {3, 4, 5}}));
  }
}

TEST(StlReader, SeveralSolidsOneAfterTheOther) {
  const std::string file = text_stl({kTwoFacets[0]}) + text_stl({kTwoFacets[1]});
  const Mesh mesh = read_text(file, MeshFormat::Stl);
  ASSERT_EQ(mesh.positions.size(), 6U);
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[5], Vec3(0, 1, 0.5));
  EXPECT_EQ(mesh.triangles, (Corners{{0, 1, 2}, {3, 4, 5}}));
}

// The second facet repeats a corner: it has no area and still has its three vertices.
TEST(StlReader, FacetsWithoutAreaKeepTheirVertices) {
  const std::vector<Facet> facets{
      kTwoFacets[0], {{{2, 0, 0}, {2, 0, 0}, {3, 0, 0}}}, kTwoFacets[1]};
  for (const std::string& file : {binary_stl(facets), text_stl(facets)}) {
    EXPECT_EQ(read_text(file, MeshFormat::Stl).positions.size(), 9U);
  }
}

TEST(StlReader, LettersAndBlanksAsPeopleWriteThem) {
  const std::string file =
      "SOLID\r\n\r\nFACET NORMAL 0 0 1\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\n\tVertex +1 0 -1e0\r\n"
      "VERTEX 0 .5 0\r\nENDLOOP\r\nENDFACET\r\nENDSOLID name of it\r\n";
  EXPECT_EQ(read_text(file, MeshFormat::Stl).positions,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, -1}, {0, 0.5, 0}}));
}

}  // namespace
}  // namespace regarment::test
