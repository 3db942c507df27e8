// Scans with very many vertices, through a thinner copy.
#include "scan/thin_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "scan/cone_person.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

using namespace test;

TEST(ThinMesh, HasAboutTheVerticesWantedNearThoseTheyStandFor) {
  const Mesh mesh = made_person({}, 0.006);
  for (const std::size_t wanted : {2000u, 5000u}) {
    const ThinMesh thin = thin_mesh(mesh, wanted);
    EXPECT_NEAR(static_cast<double>(thin.mesh.positions.size()), static_cast<double>(wanted),
                0.3 * static_cast<double>(wanted));
    // No cell is larger than what all of them would be in a single sheet over the surface.
    const double cell = std::sqrt(2 * 2.5 / static_cast<double>(wanted));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const Vec3& mean = thin.mesh.positions[thin.of_vertex[v]];
      EXPECT_LT((mean - mesh.positions[v]).norm(), std::sqrt(3) * cell);
    }
    for (const Triangle& t : thin.mesh.triangles) {
      EXPECT_LT(*std::max_element(t.begin(), t.end()), thin.mesh.positions.size());
      EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    }
  }
}

TEST(ThinMesh, DoesNotDependOnTheOrderOfVertices) {
  const Mesh cloud = cloud_of(made_cloud({}, 20000));
  std::vector<std::uint32_t> order(cloud.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Mesh shuffled;
  for (const std::uint32_t i : order) shuffled.positions.push_back(cloud.positions[i]);
  const ThinMesh one = thin_mesh(cloud, 3000), other = thin_mesh(shuffled, 3000);
  ASSERT_EQ(one.mesh.positions.size(), other.mesh.positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(one.of_vertex[order[i]], other.of_vertex[i]);
  }
}

TEST(ThinMesh, KeepsTheTwoSidesOfThinClothApart) {
  Mesh cloth = made_box(Vec3(1.0, 0.0005, 1.0), 0.01);
  const ThinMesh thin = thin_mesh(cloth, 1500);
  for (std::size_t v = 0; v < cloth.positions.size(); ++v) {
    const double y = cloth.positions[v].y();
    EXPECT_NEAR(thin.mesh.positions[thin.of_vertex[v]].y(), y, 1e-9);  // a mean of these
  }
}

TEST(ThinMesh, LeavesOutNumbersThatAreNoneAndBearsOnePlace) {
  Mesh cloud;
  cloud.positions.assign(1000, Vec3(1, 2, 3));
  cloud.positions[7].y() = std::nan("");
  const ThinMesh thin = thin_mesh(cloud, 100);
  ASSERT_EQ(thin.mesh.positions.size(), 1u);
  EXPECT_LT((thin.mesh.positions[0] - Vec3(1, 2, 3)).norm(), 1e-12);
  EXPECT_EQ(thin.of_vertex[7], ThinMesh::kNone);
  EXPECT_EQ(thin.of_vertex[8], 0u);
}

std::vector<std::string> codes_of(const Scan& scan) {
  std::vector<std::string> codes;
  for (const Finding& finding : scan.facts.findings) codes.push_back(finding.code);
  return codes;
}

TEST(ScanOfManyVertices, StandsAsItDoesWithoutThinning) {
  Mesh mesh = made_person({.skirt_hem = 0.5}, 0.008);
  const std::size_t person = mesh.positions.size();
  append(mesh, moved(made_box(Vec3(0.3, 0.4, 0.2), 0.01), Eigen::Matrix3d::Identity(), 1.0,
                     Vec3(0.8, 0, -0.2)));
  const Scan whole = make_scan(mesh), thinned = make_scan(mesh, {.most_vertices = 12000});
  EXPECT_EQ(whole.thin, nullptr);
  ASSERT_NE(thinned.thin, nullptr);
  EXPECT_EQ(codes_of(thinned), (std::vector<std::string>{"coarsened", "island"}));
  // The words count vertices of the file.
  EXPECT_EQ(thinned.facts.findings[1].found, whole.facts.findings[0].found);
  EXPECT_EQ(thinned.facts.up, whole.facts.up);
  EXPECT_EQ(thinned.facts.units, whole.facts.units);
  EXPECT_NEAR(thinned.facts.height, whole.facts.height, 0.01);
  EXPECT_NEAR(thinned.facts.spacing, whole.facts.spacing, 0.1 * whole.facts.spacing);
  EXPECT_LT(thinned.thin->scan.mesh.positions.size(), 12000u);
  EXPECT_EQ(thinned.thin->of_vertex.size(), mesh.positions.size());
  std::size_t against = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_LT((thinned.file_from_body * thinned.mesh.positions[v] - mesh.positions[v]).norm(),
              1e-9);
    EXPECT_EQ(thinned.outlier[v], v >= person);
    if (v < person && thinned.mesh.normals[v].dot(whole.mesh.normals[v]) < 0.5) ++against;
  }
  EXPECT_LT(against, person / 50);  // at creases between the parts
}

TEST(ScanOfManyVertices, TurnsTrianglesThatFaceInward) {
  const Mesh outward = made_person({}, 0.008);
  Mesh inward = outward;
  for (Triangle& t : inward.triangles) std::swap(t[1], t[2]);
  const Scan scan = make_scan(inward, {.most_vertices = 12000});
  EXPECT_EQ(codes_of(scan), (std::vector<std::string>{"inward_normals", "coarsened"}));
  std::size_t inside = 0;
  const Eigen::Affine3d body_from_file = scan.file_from_body.inverse();
  for (std::size_t t = 0; t < outward.triangles.size(); ++t) {
    const auto [a, b, c] = outward.triangles[t];
    const Vec3 area = (outward.positions[b] - outward.positions[a])
                          .cross(outward.positions[c] - outward.positions[a]);
    const auto [i, j, k] = scan.mesh.triangles[t];
    const Vec3 found = (scan.mesh.positions[j] - scan.mesh.positions[i])
                           .cross(scan.mesh.positions[k] - scan.mesh.positions[i]);
    inside += found.dot(body_from_file.linear() * area) < 0 ? 1 : 0;
  }
  EXPECT_LT(inside, outward.triangles.size() / 50);
}

TEST(ScanOfManyVertices, SaysItsNumbersThatAreNone) {
  Mesh mesh = made_person({}, 0.008);
  mesh.positions[10].x() = std::nan("");
  const Scan scan = make_scan(mesh, {.most_vertices = 12000});
  EXPECT_EQ(codes_of(scan), (std::vector<std::string>{"coarsened", "not_a_number"}));
  EXPECT_EQ(scan.outlier[10], 1);
  EXPECT_EQ(scan.mesh.positions[10], Vec3(0, 0, 0));
}

}  // namespace
}  // namespace regarment
