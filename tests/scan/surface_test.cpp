// What a surface shows by itself: normals, winding, holes, noise and spacing.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "scan/cone_person.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

using namespace test;

/// Share of vertices whose normal lies on the true normal's side.
double outward_share(const Scan& scan, const std::vector<Vec3>& truth) {
  std::size_t outward = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    const Vec3 in_file = scan.file_from_body.linear() * scan.mesh.normals[v];
    outward += in_file.dot(truth[v]) > 0 ? 1 : 0;
  }
  return static_cast<double>(outward) / static_cast<double>(truth.size());
}

TEST(CloudNormals, PointOutward) {
  for (const PersonShape& shape : {PersonShape{}, PersonShape{.skirt_hem = 0.5}}) {
    Mesh cloud = made_cloud(shape, 60000, 0.0005);
    const std::vector<Vec3> truth = cloud.normals;
    cloud.normals.clear();
    const Scan scan = make_scan(cloud);
    EXPECT_GT(outward_share(scan, truth), 0.99);
    for (const Vec3& n : scan.mesh.normals) EXPECT_NEAR(n.norm(), 1.0, 1e-6);
  }
}

TEST(CloudNormals, PointOutwardDespitePointsFarAway) {
  Mesh cloud = made_cloud({}, 30000, 0.0005);
  const std::vector<Vec3> truth = cloud.normals;
  cloud.normals.clear();
  for (const double far : {1e2, -1e5, 1e300, -1e300}) cloud.positions.emplace_back(far, far, 1.0);
  const Scan scan = make_scan(cloud);
  EXPECT_GT(outward_share(scan, truth), 0.99);
  for (std::size_t v = truth.size(); v < cloud.positions.size(); ++v) {
    EXPECT_EQ(scan.outlier[v], 1);
    EXPECT_NEAR(scan.mesh.normals[v].norm(), 1.0, 1e-6);
  }
}

TEST(CloudNormals, OfAVeryLargeCloudFollowASample) {
  Mesh cloud = made_cloud({}, 560000, 0.0001);
  const std::vector<Vec3> truth = cloud.normals;
  cloud.normals.clear();
  const double density = static_cast<double>(cloud.positions.size()) / seen_area({});
  const Scan scan = make_scan(std::move(cloud));
  EXPECT_GT(outward_share(scan, truth), 0.99);
  EXPECT_NEAR(scan.facts.noise, 0.0001, 0.00002);
  const double median = std::sqrt(std::log(2.0) / (3.14159265358979 * density));
  EXPECT_NEAR(scan.facts.spacing, median, 0.1 * median);
}

TEST(CloudNormals, OfTheFileAreKeptWhenPlausible) {
  const Mesh cloud = made_cloud({}, 30000);
  const Scan scan = make_scan(cloud);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < cloud.normals.size(); ++v) {
    const Vec3 in_file = scan.file_from_body.linear() * scan.mesh.normals[v];
    kept += (in_file.normalized() - cloud.normals[v]).norm() < 1e-9 ? 1 : 0;
  }
  // At creases the estimated plane differs, and the estimate stands.
  EXPECT_GT(kept, cloud.normals.size() * 9 / 10);
  EXPECT_TRUE(scan.facts.findings.empty());
}

TEST(CloudNormals, OfTheFileAreTurnedWhenInward) {
  Mesh cloud = made_cloud({}, 30000);
  const std::vector<Vec3> truth = cloud.normals;
  for (Vec3& n : cloud.normals) n = -n;
  const Scan scan = make_scan(cloud);
  EXPECT_GT(outward_share(scan, truth), 0.99);
  ASSERT_EQ(scan.facts.findings.size(), 1u);
  EXPECT_EQ(scan.facts.findings[0].code, "inward_normals");
}

TEST(CloudNormals, OfTheFileAreReplacedWhenMeaningless) {
  Mesh cloud = made_cloud({}, 30000);
  const std::vector<Vec3> truth = cloud.normals;
  for (Vec3& n : cloud.normals) n = Vec3(0, 1, 0);
  const Scan scan = make_scan(cloud);
  EXPECT_GT(outward_share(scan, truth), 0.99);
  ASSERT_EQ(scan.facts.findings.size(), 1u);
  EXPECT_EQ(scan.facts.findings[0].code, "replaced_normals");
}

TEST(Noise, IsThatOfTheCloud) {
  for (const double noise : {0.0003, 0.001, 0.003}) {
    Mesh cloud = made_cloud({}, 60000, noise);
    cloud.normals.clear();
    EXPECT_NEAR(make_scan(cloud).facts.noise, noise, 0.2 * noise);
  }
}

TEST(Spacing, IsThatOfRandomPoints) {
  // The nearest of points spread at random with density d is closer than r with probability
  // 1 - exp(-pi d r^2), so the median is sqrt(ln 2 / (pi d)).
  Mesh cloud = made_cloud({}, 40000);
  cloud.normals.clear();
  const double density = static_cast<double>(cloud.positions.size()) / seen_area({});
  const double median = std::sqrt(std::log(2.0) / (3.14159265358979 * density));
  EXPECT_NEAR(make_scan(cloud).facts.spacing, median, 0.1 * median);
}

/// Signed volume of the surface in the body frame.
double volume(const Mesh& mesh) {
  double six = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
  }
  return six / 6;
}

TEST(Winding, OfAnInwardMeshIsTurned) {
  const Mesh outward = made_person();
  Mesh inward = outward;
  for (Triangle& t : inward.triangles) std::swap(t[1], t[2]);
  const Scan scan = make_scan(inward);
  EXPECT_NEAR(volume(scan.mesh), volume(make_scan(outward).mesh), 1e-9);
  ASSERT_EQ(scan.facts.findings.size(), 1u);
  EXPECT_EQ(scan.facts.findings[0].code, "inward_normals");
}

TEST(Winding, OfSingleTrianglesIsMended) {
  const Mesh right = made_person();
  Mesh mixed = right;
  std::mt19937 random(2);
  for (Triangle& t : mixed.triangles) {
    if (random() % 4 == 0) std::swap(t[1], t[2]);
  }
  const Scan scan = make_scan(mixed), truth = make_scan(right);
  EXPECT_NEAR(volume(scan.mesh), volume(truth.mesh), 1e-9);
  for (std::size_t v = 0; v < scan.mesh.normals.size(); ++v) {
    EXPECT_GT(scan.mesh.normals[v].dot(truth.mesh.normals[v]), 0.999);
  }
}

TEST(MeshNormals, OfASoupOfTrianglesAreSmooth) {
  const Mesh shared = made_person();
  Mesh soup;
  std::vector<std::uint32_t> source;
  for (const Triangle& t : shared.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t v : t) {
      soup.positions.push_back(shared.positions[v]);
      source.push_back(v);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const Scan scan = make_scan(soup), truth = make_scan(shared);
  EXPECT_EQ(scan.facts.holes, 0u);
  for (std::size_t v = 0; v < source.size(); ++v) {
    EXPECT_GT(scan.mesh.normals[v].dot(truth.mesh.normals[source[v]]), 0.999999);
  }
}

TEST(MeshNormals, OfVerticesNoTriangleUsesComeFromTheNearest) {
  Mesh mesh = made_person();
  mesh.positions.push_back(mesh.positions[100] * 1.0001);
  const Scan scan = make_scan(mesh);
  EXPECT_LT((scan.mesh.normals.back() - scan.mesh.normals[100]).norm(), 1e-9);
}

TEST(Holes, AreCountedByTheirLoops) {
  Mesh mesh = made_person();
  EXPECT_EQ(make_scan(mesh).facts.holes, 0u);
  const auto corners_touch = [&](std::size_t t, std::size_t u) {
    for (const std::uint32_t a : mesh.triangles[t]) {
      for (const std::uint32_t b : mesh.triangles[u]) {
        if (a == b) return true;
      }
    }
    return false;
  };
  const std::size_t one = 500, two = 3000;
  ASSERT_FALSE(corners_touch(one, two));
  mesh.triangles.erase(mesh.triangles.begin() + two);
  mesh.triangles.erase(mesh.triangles.begin() + one);
  EXPECT_EQ(make_scan(mesh).facts.holes, 2u);
}

TEST(Outliers, AreIslandsOfAMesh) {
  Mesh mesh = made_person();
  const std::size_t real = mesh.positions.size();
  append(mesh, made_sphere(0.02, Vec3(0.5, 0.3, 0.4)));
  const Scan scan = make_scan(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(scan.outlier[v], v >= real);
  EXPECT_EQ(scan.facts.outliers, mesh.positions.size() - real);
}

}  // namespace
}  // namespace regarment
