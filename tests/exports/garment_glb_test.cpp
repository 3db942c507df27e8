#include "exports/garment_glb.h"

#include <numeric>
#include <set>

#include "base/error.h"
#include "garments.h"
#include "read_glb.h"

namespace regarment {
namespace {

constexpr double kFloat = 1e-6;  // m, of lengths of about a metre as floats

class GarmentGlb : public testing::Test {
 protected:
  std::vector<float> attribute(const char* name) const {
    const auto document = document_of(glb_);
    return numbers_of<float>(glb_, document["meshes"][0]["primitives"][0]["attributes"][name]);
  }

  const Pattern pattern_ = make_pattern(find_template("skirt"), whole_skirt(), 0.05);
  const std::vector<Vec3> draped_ = laid_flat(pattern_);
  const std::string glb_ = garment_glb({"skirt", pattern_, draped_});
};

TEST_F(GarmentGlb, TheValidatorFindsNoFault) {
  const auto report = validated(glb_);
  if (report.is_null()) GTEST_SKIP() << kNoValidator;
  EXPECT_EQ(report["issues"]["numErrors"], 0) << report["issues"];
  EXPECT_EQ(report["issues"]["numWarnings"], 0) << report["issues"];
  EXPECT_EQ(report["info"]["totalTriangleCount"], pattern_.triangles.size());
  EXPECT_EQ(report["info"]["materialCount"], 2);
}

TEST_F(GarmentGlb, AssimpReadsPanelsWithPositionsAndFlatCoordinates) {
  Assimp::Importer importer;
  const aiScene* scene = read_with_assimp(importer, glb_, "glb");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 2u);
  std::size_t triangles = 0;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    triangles += mesh.mNumFaces;
    ASSERT_TRUE(mesh.HasTextureCoords(0));
    ASSERT_TRUE(mesh.HasNormals());
    // Laid flat, a panel's own vertices stand 1 m less its t up, and at its s.
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      EXPECT_NEAR(mesh.mVertices[v].x, mesh.mTextureCoords[0][v].x, kFloat);
      // assimp turns t over, as 1 - t.
      EXPECT_NEAR(mesh.mVertices[v].y, mesh.mTextureCoords[0][v].y, kFloat);
    }
  }
  EXPECT_EQ(triangles, pattern_.triangles.size());
}

TEST_F(GarmentGlb, OurReaderFindsTheSamePlaces) {
  const Mesh mesh = read_with_our_reader(glb_, MeshFormat::Glb);
  EXPECT_EQ(mesh.triangles.size(), pattern_.triangles.size());
  for (const Vec3& p : mesh.positions) {
    const bool known = std::any_of(draped_.begin(), draped_.end(),
                                   [&](const Vec3& q) { return (p - q).norm() < kFloat; });
    ASSERT_TRUE(known) << p.transpose();
  }
}

// By hand: two panels of this area.
TEST_F(GarmentGlb, WeighsItsArea) {
  const std::vector<float> masses = attribute("_MASS");
  ASSERT_EQ(masses.size(), pattern_.flat.size());
  EXPECT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0),
              kExportDensity * 2.0 * skirt_area(), 1e-6);
  EXPECT_GT(*std::min_element(masses.begin(), masses.end()), 0.0F);
}

TEST_F(GarmentGlb, RestLengthsAreDistancesInTheFlat) {
  const auto document = document_of(glb_);
  const auto& cloth = document["meshes"][0]["extras"]["cloth"];
  const auto pairs = numbers_of<std::uint32_t>(glb_, cloth["springs"]["particles_accessor"]);
  const auto lengths = numbers_of<float>(glb_, cloth["springs"]["rest_lengths_m_accessor"]);
  ASSERT_EQ(pairs.size(), 2 * lengths.size());
  const std::vector<float> particle = attribute("_PARTICLE"), flat = attribute("TEXCOORD_0");
  // Each side of each triangle, from the file's own arrays.
  std::map<std::pair<int, int>, std::set<long>> sides;  // 0.1 mm
  for (const auto& primitive : document["meshes"][0]["primitives"]) {
    const auto corners = numbers_of<std::uint32_t>(glb_, primitive["indices"]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i], b = corners[i % 3 == 2 ? i - 2 : i + 1];
      const double length =
          std::hypot(flat[2 * a] - flat[2 * b], flat[2 * a + 1] - flat[2 * b + 1]);
      const int p = static_cast<int>(particle[a]), q = static_cast<int>(particle[b]);
      sides[std::minmax(p, q)].insert(std::lround(length * 1e4));
    }
  }
  ASSERT_EQ(sides.size(), lengths.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const auto& known =
        sides.at({static_cast<int>(pairs[2 * i]), static_cast<int>(pairs[2 * i + 1])});
    EXPECT_TRUE(known.contains(std::lround(double{lengths[i]} * 1e4)));
  }
}

TEST_F(GarmentGlb, NeedsOnePlacePerVertex) {
  const std::vector<Vec3> fewer(draped_.begin(), draped_.end() - 1);
  EXPECT_THROW(garment_glb({"skirt", pattern_, fewer}), InvalidInput);
}

}  // namespace
}  // namespace regarment
