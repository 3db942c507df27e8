#include "render/display_mesh.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "render/display_normals.h"
#include "render/shapes.h"

namespace regarment {
namespace {

TEST(DisplayMesh, KeepsASmallMeshAsItIs) {
  const Mesh mesh = test::box_mesh({1, 2, 3}, {2, 3, 4});
  const DisplayMesh display = make_display_mesh(mesh, {}, {}, {1, 2, 3}, 1000);
  ASSERT_EQ(display.positions.size(), 8U);
  EXPECT_EQ(display.triangles, mesh.triangles);
  EXPECT_TRUE(display.positions[7].isApprox(Eigen::Vector3f(1, 1, 1)));
  EXPECT_EQ(display.source_triangle[11], 11U);
}

TEST(DisplayMesh, ThinsALargeMeshToTheLimitAndStaysOnTheSurface) {
  const Mesh mesh = test::sphere_mesh(1.0, 150);  // 89,400 triangles
  const DisplayMesh display = make_display_mesh(mesh, {}, {}, Vec3::Zero(), 20'000);
  EXPECT_LE(display.triangles.size(), 20'000U);
  EXPECT_GT(display.triangles.size(), 14'000U);  // not much coarser than asked for
  const double cell = 0.06;                      // m: sphere of 12.6 m2 in ten thousand clusters
  for (std::size_t i = 0; i < display.positions.size(); ++i) {
    EXPECT_NEAR(double(display.positions[i].norm()), 1.0, 0.002);
    const Vec3 source = mesh.positions[display.source_vertex[i]];
    EXPECT_LT((source - display.positions[i].cast<double>()).norm(), cell);
    EXPECT_GT(display.normals[i].dot(display.positions[i].normalized()), 0.999F);
  }
  for (const Triangle& t : display.triangles) {
    EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  }
}

TEST(DisplayMesh, ShowsTheNearestVertexOfItsCluster) {
  const Mesh cloud = test::sphere_cloud(1.0, 5000, 4);
  const DisplayMesh display = make_display_mesh(cloud, {}, {}, Vec3::Zero(), 1000);
  EXPECT_LE(display.positions.size(), 1000U);
  for (std::size_t i = 0; i < display.positions.size(); ++i) {
    const Vec3 here = display.positions[i].cast<double>();
    // No vertex of any cluster can be nearer than that of its own by more than a cell's diagonal.
    double nearest = 1e9;
    for (const Vec3& p : cloud.positions) nearest = std::min(nearest, (p - here).norm());
    EXPECT_LE((cloud.positions[display.source_vertex[i]] - here).norm(),
              nearest + std::sqrt(3.0) * display.spacing);
  }
}

TEST(DisplayMesh, NeverMixesLabelsInACluster) {
  const Mesh mesh = test::sphere_mesh(1.0, 120);
  std::vector<std::uint8_t> labels;
  for (const Vec3& p : mesh.positions) labels.push_back(p.y() > 0.123 ? 1 : 0);
  const DisplayMesh display = make_display_mesh(mesh, labels, {}, Vec3::Zero(), 5'000);
  for (std::size_t i = 0; i < display.positions.size(); ++i) {
    // The mean of vertices of one side lies on that side.
    EXPECT_EQ(labels[display.source_vertex[i]] == 1, display.positions[i].y() > 0.123F);
  }
}

TEST(DisplayMesh, KeepsTheSidesOfAThinSheetApart) {
  Mesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 0.001});
  mesh = Mesh();
  for (const double z : {0.001, 0.0}) {
    for (int i = 0; i < 100; ++i) {
      for (int j = 0; j < 100; ++j) {
        mesh.positions.emplace_back(i / 99.0, j / 99.0, z);
        mesh.normals.emplace_back(0, 0, z > 0 ? 1 : -1);
      }
    }
  }
  const DisplayMesh display = make_display_mesh(mesh, {}, {}, Vec3::Zero(), 1000);
  for (const auto& normal : display.normals) EXPECT_NEAR(double(std::abs(normal.z())), 1.0, 1e-6);
}

TEST(DisplayMesh, LeavesOutliersOut) {
  Mesh mesh = test::sphere_mesh(1.0, 10);
  std::vector<std::uint8_t> outlier(mesh.positions.size(), 0);
  outlier[30] = 1;
  mesh.positions[30] = {1000, 0, 0};
  for (const std::size_t limit : {std::size_t(1'000'000), std::size_t(200)}) {
    const DisplayMesh display = make_display_mesh(mesh, {}, outlier, Vec3::Zero(), limit);
    for (const auto& p : display.positions) EXPECT_LT(p.norm(), 3.0F);
    for (const std::uint32_t t : display.source_triangle) {
      for (const std::uint32_t corner : mesh.triangles[t]) EXPECT_NE(corner, 30U);
    }
  }
  const std::vector<std::uint8_t> all(mesh.positions.size(), 1);
  EXPECT_TRUE(make_display_mesh(mesh, {}, all, Vec3::Zero(), 1000).positions.empty());
}

TEST(DisplayMesh, ShowsAHandfulOfPoints) {
  Mesh cloud;
  cloud.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const DisplayMesh display = make_display_mesh(cloud, {}, {}, Vec3::Zero(), 1000);
  EXPECT_EQ(display.positions.size(), 3U);
  EXPECT_LT(display.spacing, 0.1);
}

TEST(DisplayMesh, NamesAVertexThatIsNotFinite) {
  Mesh cloud;
  cloud.positions = {{0, 0, 0}, {1, 0, std::nan("")}};
  EXPECT_THROW(make_display_mesh(cloud, {}, {}, Vec3::Zero(), 1000), InvalidInput);
}

TEST(DisplayMesh, FindsTheNormalsOfACloudWithoutAny) {
  Mesh cloud = test::sphere_cloud(1.0, 20'000, 8);
  cloud.normals.clear();
  const DisplayMesh display = make_display_mesh(cloud, {}, {}, Vec3::Zero(), 60'000);
  double mean = 0.0;
  for (std::size_t i = 0; i < display.positions.size(); ++i) {
    mean += double(std::abs(display.normals[i].dot(display.positions[i].normalized())));
  }
  EXPECT_GT(mean / double(display.positions.size()), 0.99);
}

TEST(DisplayMesh, SewnPanelsLookSmooth) {
  // Two quads that meet along x = 0 at a right angle, each with its own vertices on the seam.
  const std::vector<Vec3> positions = {{-1, 0, -1}, {0, 0, 0},  {0, 1, 0},  {-1, 1, -1},
                                       {0, 0, 0},   {1, 0, -1}, {1, 1, -1}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const DisplayMesh display = make_display_mesh(positions, triangles, Vec3::Zero());
  EXPECT_TRUE(display.normals[1].isApprox(display.normals[4]));
  EXPECT_TRUE(display.normals[2].isApprox(display.normals[7]));
}

TEST(VertexNormals, RefuseAnIndexOutOfRange) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 3}};
  EXPECT_THROW(vertex_normals(positions, triangles), InvalidInput);
}

}  // namespace
}  // namespace regarment
