#include "exports/garment_obj.h"

#include <set>

#include "base/error.h"
#include "garments.h"
#include "read_glb.h"

namespace regarment {
namespace {

constexpr double kDigits = 1e-6;  // m, the file's last digit

class GarmentObj : public testing::Test {
 protected:
  const Pattern pattern_ = make_pattern(find_template("skirt"), whole_skirt(), 0.05);
  const std::vector<Vec3> draped_ = laid_flat(pattern_);
  const std::string obj_ = garment_obj({"skirt", pattern_, draped_});
};

TEST_F(GarmentObj, OurReaderFindsASewnMesh) {
  const Mesh mesh = read_with_our_reader(obj_, MeshFormat::Obj);
  ASSERT_EQ(mesh.positions.size(), static_cast<std::size_t>(pattern_.particle_count));
  EXPECT_EQ(mesh.triangles.size(), pattern_.triangles.size());
  for (std::size_t v = 0; v < draped_.size(); ++v) {
    const Vec3& p = mesh.positions[static_cast<std::size_t>(pattern_.particle[v])];
    EXPECT_LT((p - draped_[v]).norm(), kDigits);
  }
  // A sewn skirt is open at waist and hem only: V - E + F of a tube is 0.
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      edges.insert(std::minmax(p, q));
  EXPECT_EQ(mesh.positions.size() + mesh.triangles.size(), edges.size());
}

TEST_F(GarmentObj, AssimpReadsItsFlatCoordinates) {
  Assimp::Importer importer;
  const aiScene* scene = read_with_assimp(importer, obj_, "obj");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  std::size_t triangles = 0;
  double area = 0.0;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    triangles += mesh.mNumFaces;
    ASSERT_TRUE(mesh.HasTextureCoords(0));
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const unsigned* i = mesh.mFaces[f].mIndices;
      const aiVector3D* t = mesh.mTextureCoords[0];
      const aiVector3D u = t[i[1]] - t[i[0]], v = t[i[2]] - t[i[0]];
      area += std::abs(double{u.x} * double{v.y} - double{u.y} * double{v.x}) / 2.0;
    }
  }
  EXPECT_EQ(triangles, pattern_.triangles.size());
  EXPECT_NEAR(area, 2.0 * skirt_area(), 1e-5);  // by hand
}

TEST_F(GarmentObj, NeedsOnePlacePerVertex) {
  const std::vector<Vec3> fewer(draped_.begin(), draped_.end() - 1);
  EXPECT_THROW(garment_obj({"skirt", pattern_, fewer}), InvalidInput);
}

}  // namespace
}  // namespace regarment
