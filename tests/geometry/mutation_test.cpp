// Thousands of damaged files per format: each is refused with ReadError or read as a valid mesh.
#include <gtest/gtest.h>

#include <random>

#include "geometry/read_text.h"
#include "support/mutate.h"
#include "support/ply_maker.h"
#include "support/stl_maker.h"

namespace regarment::test {
namespace {

constexpr int kFiles = 4000;  // per seed file

// Returns how many of the mutants were read, so that a caller sees both outcomes happened.
int expect_survives(const std::string& file, MeshFormat format) {
  std::mt19937 random(20240607);
  expect_valid(read_text(file, format));
  int read = 0;
  for (int i = 0; i < kFiles; ++i) {
    const std::string mutant = mutate(file, random);
    try {
      expect_valid(read_text(mutant, format, {.max_vertices = 100'000, .max_triangles = 100'000}));
      ++read;
    } catch (const ReadError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with("test file: ")) << message;
      EXPECT_EQ(message.find_first_of("\n\r"), std::string::npos) << message;
    }
    if (testing::Test::HasFatalFailure()) {
      ADD_FAILURE() << "mutant " << i;
      return read;
    }
  }
  return read;
}

void expect_survives_both_ways(const std::string& file, MeshFormat format) {
  const int read = expect_survives(file, format);
  EXPECT_GT(read, 0);
  EXPECT_LT(read, kFiles);
}

std::string small_ply(PlyForm form) {
  PlyMaker ply(form);
  ply.header("comment small").header("element vertex 4").header("property float x");
  ply.header("property double y").header("property short z").header("property list uchar int k");
  for (const char* name : {"nx", "ny", "nz"}) ply.header(std::string("property float ") + name);
  for (const char* name : {"red", "green", "blue"}) {
    ply.header(std::string("property uchar ") + name);
  }
  ply.header("element face 2").header("property list uchar int vertex_indices");
  ply.header("end_header");
  for (int i = 0; i < 4; ++i) {
    ply.value("float", i).value("double", 0.5 * i).value("short", -i).value("uchar", 1);
    ply.value("int", 7);
    for (int axis = 0; axis < 3; ++axis) ply.value("float", axis == i ? 1 : 0);
    for (int channel = 0; channel < 3; ++channel) ply.value("uchar", 40 * i + channel);
    ply.end_row();
  }
  for (const std::vector<int>& face : {std::vector<int>{0, 1, 2, 3}, std::vector<int>{3, 2, 0}}) {
    ply.value("uchar", static_cast<double>(face.size()));
    for (const int corner : face) ply.value("int", corner);
    ply.end_row();
  }
  return ply.text();
}

TEST(Mutation, AsciiPly) { expect_survives_both_ways(small_ply(PlyForm::Ascii), MeshFormat::Ply); }
TEST(Mutation, LittlePly) {
  expect_survives_both_ways(small_ply(PlyForm::Little), MeshFormat::Ply);
}
TEST(Mutation, BigPly) { expect_survives_both_ways(small_ply(PlyForm::Big), MeshFormat::Ply); }

TEST(Mutation, Obj) {
  expect_survives_both_ways(
      "# small\nmtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\n"
      "v 0 1 0.5 1 1 1\nvt 0 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 -1\n"
      "f 1/1/1 2/1/2 3//3\nf -4 -2 \\\n-1\nl 1 2\n",
      MeshFormat::Obj);
}

// A changed count or length is always refused: only numbers may change.
TEST(Mutation, BinaryStl) {
  const Facet facet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  expect_survives_both_ways(binary_stl({facet, facet}), MeshFormat::Stl);
}

TEST(Mutation, TextStl) {
  expect_survives_both_ways(
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n",
      MeshFormat::Stl);
}

TEST(Mutation, Off) {
  expect_survives_both_ways(
      "COFF\n# small\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n1 1 0 0 0 255 255\n"
      "0 1 .5 9 9 9 255\n4 0 1 2 3 255 0 0\n3 0 2 3\n",
      MeshFormat::Off);
}

}  // namespace
}  // namespace regarment::test
