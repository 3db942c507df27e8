#include "exports/scan_glb.h"

#include <limits>

#include "base/error.h"
#include "read_glb.h"

namespace regarment {
namespace {

/// Four points, two triangles; the second vertex is the garment's.
struct Square {
  Mesh mesh;
  std::vector<std::uint8_t> labels = {0, 1, 0, 0};
  std::vector<float> probability = {1.0F, 0.5F, 0.75F, 1.0F};
  std::vector<Colour> colours = {{0, 0, 0}, {255, 255, 255}, {188, 0, 0}, {0, 0, 0}};

  Square() {
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  }
  std::string glb() const {
    Eigen::Affine3d file_from_mesh = Eigen::Affine3d::Identity();
    file_from_mesh.linear() *= 1000.0;
    file_from_mesh.translation() = Vec3(7, 8, 9);
    return scan_glb({mesh, labels, probability, colours, file_from_mesh});
  }
  std::vector<float> attribute(const char* name) const {
    const auto document = document_of(glb());
    return numbers_of<float>(glb(), document["meshes"][0]["primitives"][0]["attributes"][name]);
  }
};

void expect_valid(const std::string& glb) {
  const auto report = validated(glb);
  if (report.is_null()) GTEST_SKIP() << kNoValidator;
  EXPECT_EQ(report["issues"]["numErrors"], 0) << report["issues"];
  EXPECT_EQ(report["issues"]["numWarnings"], 0) << report["issues"];
}

TEST(ScanGlb, IsValidAsMeshAndAsCloud) {
  Square square;
  expect_valid(square.glb());
  square.mesh.triangles.clear();
  expect_valid(square.glb());
}

TEST(ScanGlb, KeepsVerticesLabelsAndProbabilitiesInOrder) {
  const Square square;
  EXPECT_EQ(square.attribute("POSITION"), (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0}));
  EXPECT_EQ(square.attribute("_LABEL"), (std::vector<float>{0, 1, 0, 0}));
  EXPECT_EQ(square.attribute("_PROBABILITY"), square.probability);
}

// sRGB 188 is linear 0.503, by the standard's formula.
TEST(ScanGlb, ColoursAreLinear) {
  const std::string glb = Square().glb();
  const int accessor = document_of(glb)["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"];
  EXPECT_EQ(
      numbers_of<std::uint8_t>(glb, accessor),
      (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255, 128, 0, 0, 255, 0, 0, 0, 255}));
}

TEST(ScanGlb, AssimpAndOurReaderFindTheSameTriangles) {
  const Square square;
  Assimp::Importer importer;
  const aiScene* scene = read_with_assimp(importer, square.glb(), "glb");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 1u);
  EXPECT_EQ(scene->mMeshes[0]->mNumVertices, 4u);
  EXPECT_EQ(scene->mMeshes[0]->mNumFaces, 2u);
  ASSERT_TRUE(scene->mMeshes[0]->HasVertexColors(0));
  EXPECT_NEAR(scene->mMeshes[0]->mColors[0][2].r, 128.0 / 255.0, 1e-6);
  const Mesh mesh = read_with_our_reader(square.glb(), MeshFormat::Glb);
  EXPECT_EQ(mesh.triangles, square.mesh.triangles);
}

TEST(ScanGlb, LeadsBackToTheFilesFrame) {
  const auto document = document_of(Square().glb());
  const std::vector<double> m = document["scenes"][0]["extras"]["file_from_scene"];
  EXPECT_EQ(m, (std::vector<double>{1000, 0, 0, 0, 0, 1000, 0, 0, 0, 0, 1000, 0, 7, 8, 9, 1}));
}

TEST(ScanGlb, WhatIsNotFiniteIsNotShown) {
  Square square;
  square.mesh.positions[1].x() = std::numeric_limits<double>::quiet_NaN();
  expect_valid(square.glb());
  EXPECT_EQ(read_with_our_reader(square.glb(), MeshFormat::Glb).triangles.size(), 1u);
  square.mesh.triangles.clear();
  expect_valid(square.glb());
  const auto document = document_of(square.glb());
  const auto shown =
      numbers_of<std::uint32_t>(square.glb(), document["meshes"][0]["primitives"][0]["indices"]);
  EXPECT_EQ(shown, (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST(ScanGlb, SizesMustAgree) {
  Square square;
  square.labels.pop_back();
  EXPECT_THROW(square.glb(), InvalidInput);
  EXPECT_THROW(scan_glb({Mesh{}, {}, {}, {}}), InvalidInput);
}

}  // namespace
}  // namespace regarment
