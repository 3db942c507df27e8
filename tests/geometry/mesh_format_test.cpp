#include <gtest/gtest.h>

#include "geometry/read_text.h"
#include "support/stl_maker.h"

namespace regarment::test {
namespace {

MeshFormat recognise(const std::string& file, const char* name) {
  return recognise_format(std::as_bytes(std::span(file)), name);
}

TEST(RecogniseFormat, ByContentWhateverTheName) {
  const std::string stl = binary_stl({Facet{}});
  for (const char* name : {"scan", "scan.dat", "folder.ply/scan"}) {
    EXPECT_EQ(recognise("ply\nformat", name), MeshFormat::Ply);
    EXPECT_EQ(recognise("ply\r\nformat", name), MeshFormat::Ply);
    EXPECT_EQ(recognise("glTF....", name), MeshFormat::Glb);
    EXPECT_EQ(recognise("{ \"asset\": {} }", name), MeshFormat::Gltf);
    EXPECT_EQ(recognise("OFF\n", name), MeshFormat::Off);
    EXPECT_EQ(recognise("CNOFF 3 1 0\n", name), MeshFormat::Off);
    EXPECT_EQ(recognise("solid a\nfacet normal", name), MeshFormat::Stl);
    EXPECT_EQ(recognise(stl, name), MeshFormat::Stl);
  }
}

TEST(RecogniseFormat, ByNameWhereContentIsSilent) {
  EXPECT_EQ(recognise("v 0 0 0\n", "a.obj"), MeshFormat::Obj);
  EXPECT_EQ(recognise("v 0 0 0\n", "A.OBJ"), MeshFormat::Obj);
  EXPECT_EQ(recognise("# a comment\nOFF\n", "a.off"), MeshFormat::Off);
  EXPECT_EQ(recognise("solid empty", "a.StL"), MeshFormat::Stl);
}

// Exporters write the word "solid" into the free text of binary files.
TEST(RecogniseFormat, BinaryStlThatBeginsWithSolid) {
  std::string stl = binary_stl({Facet{}});
  stl.replace(0, 5, "solid");
  EXPECT_EQ(recognise(stl, "a.stl"), MeshFormat::Stl);
  EXPECT_EQ(read_text(stl, MeshFormat::Stl).positions.size(), 3U);
}

TEST(RecogniseFormat, ContentAndNameMustAgree) {
  EXPECT_THROW(recognise("ply\nformat", "a.stl"), ReadError);
  EXPECT_THROW(recognise("OFF\n", "a.obj"), ReadError);
  EXPECT_THROW(recognise("MD5Version 10", "a.ply"), ReadError);
  EXPECT_THROW(recognise("whatever", "a.txt"), ReadError);
}

}  // namespace
}  // namespace regarment::test
