#include "geometry/ply_writer.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "geometry/read_text.h"
#include "support/ply_maker.h"

namespace regarment::test {
namespace {

const std::vector<Vec3> kPoints{{0, 0.5, -1}, {1, 2, 3}, {-4, 5, 6}};
const std::vector<Triangle> kTriangles{{0, 1, 2}, {2, 1, 0}};

TEST(PlyWriter, ScanWithLabelsByteForByte) {
  const std::vector<std::uint8_t> label{0, 1, 255};
  const std::vector<double> probability{0.25, 1.0, 0.5};
  const std::vector<Colour> colours{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  PlyMaker expected(PlyForm::Little);
  expected.header("element vertex 3");
  for (const char* line : {"float x", "float y", "float z", "uchar label", "float probability",
                           "uchar red", "uchar green", "uchar blue"}) {
    expected.header(std::string("property ") + line);
  }
  expected.header("element face 2").header("property list uchar int vertex_indices");
  expected.header("end_header");
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) expected.value("float", kPoints[i][axis]);
    expected.value("uchar", label[i]).value("float", probability[i]);
    for (const std::uint8_t channel : colours[i]) expected.value("uchar", channel);
  }
  for (const Triangle& triangle : kTriangles) {
    expected.value("uchar", 3);
    for (const std::uint32_t corner : triangle) expected.value("int", corner);
  }

  std::ostringstream out;
  PlyWriter(3)
      .positions(kPoints)
      .column("label", label)
      .column("probability", probability)
      .colours(colours)
      .triangles(kTriangles)
      .write(out);
  EXPECT_EQ(out.str(), expected.text());
}

TEST(PlyWriter, GarmentWithFlatCoordinatesByteForByte) {
  const std::vector<Vec2> flat{{0, 1}, {0.5, 0.25}, {-2, 3}};
  PlyMaker expected(PlyForm::Little);
  expected.header("element vertex 3");
  for (const char* name : {"x", "y", "z", "s", "t"}) {
    expected.header(std::string("property float ") + name);
  }
  expected.header("element face 2").header("property list uchar int vertex_indices");
  expected.header("end_header");
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) expected.value("float", kPoints[i][axis]);
    for (int axis = 0; axis < 2; ++axis) expected.value("float", flat[i][axis]);
  }
  for (const Triangle& triangle : kTriangles) {
    expected.value("uchar", 3);
    for (const std::uint32_t corner : triangle) expected.value("int", corner);
  }
  EXPECT_EQ(PlyWriter(3).positions(kPoints).coordinates(flat).triangles(kTriangles).bytes(),
            expected.text());
}

TEST(PlyWriter, CloudHasNoFaceElement) {
  EXPECT_EQ(PlyWriter(3).positions(kPoints).bytes().find("face"), std::string::npos);
}

TEST(PlyWriter, WhatIsWrittenIsReadBack) {
  std::mt19937 random(1);
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<Colour> colours;
  // Multiples of 2^-10 below 2^10 are exact in a float.
  const auto coordinate = [&] { return static_cast<double>(random() % 2'000'000) / 1024.0; };
  for (int i = 0; i < 1000; ++i) {
    points.emplace_back(coordinate(), -coordinate(), coordinate());
    colours.push_back({static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                       static_cast<std::uint8_t>(random())});
    triangles.push_back({static_cast<std::uint32_t>(random() % 1000),
                         static_cast<std::uint32_t>(random() % 1000),
                         static_cast<std::uint32_t>(random() % 1000)});
  }
  const Mesh mesh =
      read_text(PlyWriter(1000).colours(colours).positions(points).triangles(triangles).bytes(),
                MeshFormat::Ply);
  EXPECT_EQ(mesh.positions, points);
  EXPECT_EQ(mesh.colours, colours);
  EXPECT_EQ(mesh.triangles, triangles);
}

TEST(PlyWriter, RefusesWhatDoesNotFit) {
  EXPECT_THROW(PlyWriter(2).positions(kPoints), InvalidInput);
  EXPECT_THROW(PlyWriter(2).triangles(kTriangles), InvalidInput);
  EXPECT_THROW(PlyWriter(2).column("label", std::vector<std::uint8_t>{1}), InvalidInput);
}

}  // namespace
}  // namespace regarment::test
