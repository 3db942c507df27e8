// What is wrong with a file's mesh by itself is said, and changes nothing.
#include "scan/file_flaws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scan/cone_person.h"
#include "scan/make_scan.h"

namespace regarment {
namespace {

using namespace test;

const Finding* find(const Scan& scan, const std::string& code) {
  const auto& all = scan.facts.findings;
  const auto at = std::find_if(all.begin(), all.end(), [&](auto& f) { return f.code == code; });
  return at == all.end() ? nullptr : &*at;
}

/// The first finding's words begin with the number counted.
void expect_only(const Scan& scan, const std::string& code, const std::string& begins) {
  ASSERT_EQ(scan.facts.findings.size(), 1u);
  EXPECT_EQ(scan.facts.findings[0].code, code);
  EXPECT_EQ(scan.facts.findings[0].found.substr(0, begins.size()), begins);
}

TEST(FileFlaws, RepeatedFacesCountOnce) {
  const Mesh plain = made_person();
  Mesh mesh = plain;
  for (std::size_t t = 0; t < 90; ++t) {
    const auto [a, b, c] = plain.triangles[7 * t];
    mesh.triangles.push_back({b, c, a});
  }
  const Scan scan = make_scan(mesh), clean = make_scan(plain);
  expect_only(scan, "duplicates", "90 faces repeat");
  EXPECT_EQ(scan.mesh.triangles, clean.mesh.triangles);
  EXPECT_EQ(scan.mesh.normals, clean.mesh.normals);
  EXPECT_EQ(scan.facts.holes, clean.facts.holes);
}

TEST(FileFlaws, ASurfaceDoubledToBeSeenFromBothSidesIsOne) {
  const Mesh plain = made_person();
  Mesh mesh = plain;
  for (const auto& [a, b, c] : plain.triangles) mesh.triangles.push_back({a, c, b});
  const Scan scan = make_scan(mesh), clean = make_scan(plain);
  expect_only(scan, "duplicates", std::to_string(plain.triangles.size()) + " faces repeat");
  EXPECT_EQ(scan.mesh.triangles, clean.mesh.triangles);
  EXPECT_EQ(scan.mesh.normals, clean.mesh.normals);
}

TEST(FileFlaws, AFoldStaysClosed) {
  // A fin of two faces back to back on an edge of the surface, as meshers leave them.
  Mesh mesh = made_person();
  const auto [a, b, c] = mesh.triangles[500];
  mesh.positions.push_back(mesh.positions[a] + Vec3(0.004, 0.003, 0.005));
  const auto tip = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  mesh.triangles.push_back({a, b, tip});
  mesh.triangles.push_back({b, a, tip});
  const Scan scan = make_scan(mesh);
  EXPECT_EQ(find(scan, "duplicates"), nullptr);
  EXPECT_EQ(scan.facts.holes, 0u);
  EXPECT_EQ(scan.mesh.triangles.size(), mesh.triangles.size());
}

TEST(FileFlaws, PointsThatLieTogetherAreCounted) {
  Mesh cloud = cloud_of(made_cloud({}, 30000, 0.0005));
  cloud.normals.clear();
  for (std::size_t i = 0; i < 500; ++i) cloud.positions.push_back(cloud.positions[3 * i]);
  const Scan scan = make_scan(cloud);
  const Finding* duplicates = find(scan, "duplicates");
  ASSERT_NE(duplicates, nullptr);
  EXPECT_EQ(duplicates->found.substr(0, 10), "500 points");
}

TEST(FileFlaws, AFileThatRepeatsEveryCornerIsNotBlamed) {
  const Mesh plain = made_person();
  Mesh soup;
  for (const Triangle& t : plain.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t v : t) soup.positions.push_back(plain.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(make_scan(soup).facts.findings.empty());
}

TEST(FileFlaws, FacesWithoutAreaArePassedOver) {
  Mesh mesh = made_person();
  for (std::uint32_t i = 0; i < 40; ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({a, b, b});
    // In a line, but not of two corners alone.
    mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
    const auto middle = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    mesh.triangles.push_back({a, middle, middle});
  }
  const Scan scan = make_scan(mesh);
  expect_only(scan, "zero_area", "80 faces");
  for (const Vec3& n : scan.mesh.normals) EXPECT_NEAR(n.norm(), 1.0, 1e-9);
}

TEST(FileFlaws, EdgesOfThreeFacesAreCounted) {
  Mesh mesh = made_person();
  for (std::uint32_t i = 0; i < 12; ++i) {
    const auto [a, b, c] = mesh.triangles[50 * i];
    mesh.positions.push_back(mesh.positions[a] + Vec3(0.004, 0.003, 0.005));
    mesh.triangles.push_back({a, b, static_cast<std::uint32_t>(mesh.positions.size() - 1)});
  }
  const Scan scan = make_scan(mesh);
  const Finding* crowded = find(scan, "non_manifold");
  ASSERT_NE(crowded, nullptr);
  EXPECT_EQ(crowded->found.substr(0, 8), "12 edges");
}

TEST(FloatStep, IsTheSpacingOfSingleNumbersAtTheFarthestCoordinate) {
  // 2^20 = 1048576 and more: 23 bits of fraction leave steps of 2^-3.
  EXPECT_EQ(float_step(std::vector<Vec3>{{1.0, -1048576.0, 3.0}}), 0.125);
  EXPECT_EQ(float_step(std::vector<Vec3>{{1.0, -1048576.0, 0.1}}), 0.0);  // 0.1 is no float
  EXPECT_EQ(float_step(std::vector<Vec3>{}), 0x1p-149);
}

/// The same person, moved by `shift` metres, its numbers stored in single precision or not.
Scan far_person(const Vec3& shift, bool single) {
  Mesh mesh = moved(made_person(), Eigen::Matrix3d::Identity(), 1.0, shift);
  if (single) {
    // By way of memory: GCC 12 at -O2 drops the narrowing of two neighbours in a Vec3.
    std::vector<float> numbers;
    for (const Vec3& p : mesh.positions) {
      for (const double x : p) numbers.push_back(static_cast<float>(x));
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      mesh.positions[i / 3][static_cast<int>(i % 3)] = static_cast<double>(numbers[i]);
    }
  }
  return make_scan(mesh);
}

TEST(FileFlaws, CoordinatesFarFromTheOriginAreSaidWithTheirStep) {
  const Scan near = far_person(Vec3::Zero(), true);
  EXPECT_EQ(find(near, "far_from_origin"), nullptr);
  // 2^14 m: steps of 2^-9 m, 2 mm.
  const Scan far = far_person(Vec3(16384, 0, -300), true);
  const Finding* said = find(far, "far_from_origin");
  ASSERT_NE(said, nullptr);
  EXPECT_NE(said->found.find("steps of 2 mm"), std::string::npos) << said->found;
  EXPECT_EQ(far.facts.up, near.facts.up);
  EXPECT_NEAR(far.facts.height, near.facts.height, 0.002);
  for (std::size_t v = 0; v < near.mesh.positions.size(); ++v) {
    EXPECT_LT((far.mesh.positions[v] - near.mesh.positions[v]).norm(), 0.01);
  }
}

TEST(FileFlaws, DoubleNumbersMayLieFarFromTheOrigin) {
  const Scan near = far_person(Vec3::Zero(), false);
  const Scan far = far_person(Vec3(5e5 + 0.1, 5e6, 120), false);
  EXPECT_TRUE(far.facts.findings.empty());
  EXPECT_NEAR(far.facts.height, near.facts.height, 1e-8);  // a double's step there is 1e-9
  EXPECT_EQ(far.facts.front, near.facts.front);
}

TEST(Sampling, OfAThinAndOfANoisyCloudIsSaid) {
  Mesh thin = cloud_of(made_cloud({}, 3000));
  thin.normals.clear();
  EXPECT_NE(find(make_scan(thin), "sparse"), nullptr);
  Mesh noisy = cloud_of(made_cloud({}, 60000, 0.006));
  noisy.normals.clear();
  const Scan scan = make_scan(noisy);
  EXPECT_NE(find(scan, "noisy"), nullptr);
  EXPECT_EQ(find(scan, "sparse"), nullptr);
}

}  // namespace
}  // namespace regarment
