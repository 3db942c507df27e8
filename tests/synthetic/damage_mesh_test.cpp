#include "synthetic/damage_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "scanner_figures.h"

namespace regarment {
namespace {

SurfacedPerson ball() {
  SurfacedPerson person;
  person.mesh = test::ball(Vec3::Zero(), 0.2, 30);
  person.mesh.colours.assign(person.mesh.positions.size(), {1, 2, 3});
  person.labels.assign(person.mesh.positions.size(), 1);
  return person;
}

SurfacedPerson damaged(const MeshDamageOptions& options) {
  SurfacedPerson person = ball();
  Random random(2);
  damage_mesh(options, random, person);
  EXPECT_EQ(person.labels.size(), person.mesh.positions.size());
  EXPECT_EQ(person.mesh.colours.size(), person.mesh.positions.size());
  for (const Triangle& t : person.mesh.triangles)
    for (const std::uint32_t v : t) EXPECT_LT(v, person.mesh.positions.size());
  return person;
}

double area(const Mesh& mesh, const Triangle& t) {
  return 0.5 * (mesh.positions[t[1]] - mesh.positions[t[0]])
                   .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
                   .norm();
}

/// How many triangles each edge has.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_uses(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++uses[std::minmax({t[k], t[(k + 1) % 3]})];
  return uses;
}

TEST(DamageMesh, NoneAskedForChangesNothing) {
  EXPECT_EQ(damaged({}).mesh.triangles, ball().mesh.triangles);
}

TEST(DamageMesh, TurnedTrianglesLookInwards) {
  const Mesh mesh = damaged({.turned = 20}).mesh;
  const auto inward =
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        const Vec3& a = mesh.positions[t[0]];
        return a.dot((mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a)) < 0;
      });
  EXPECT_LE(inward, 20);
  EXPECT_GE(inward, 16);  // a triangle drawn twice is turned back
}

TEST(DamageMesh, SplitVerticesOpenTheSurfaceWhereItStays) {
  const SurfacedPerson person = damaged({.split = 10});
  EXPECT_EQ(person.mesh.positions.size(), ball().mesh.positions.size() + 10);
  const auto uses = edge_uses(person.mesh);
  EXPECT_TRUE(std::any_of(uses.begin(), uses.end(), [](const auto& e) { return e.second == 1; }));
  const Mesh before = ball().mesh;
  for (std::size_t t = 0; t < before.triangles.size(); ++t)
    EXPECT_EQ(area(person.mesh, person.mesh.triangles[t]), area(before, before.triangles[t]));
}

TEST(DamageMesh, FinsAreThirdTrianglesOfAnEdge) {
  const SurfacedPerson person = damaged({.fins = 10});
  const auto uses = edge_uses(person.mesh);
  EXPECT_GE(std::count_if(uses.begin(), uses.end(), [](const auto& e) { return e.second > 2; }), 8);
  for (std::size_t v = ball().labels.size(); v < person.labels.size(); ++v)
    EXPECT_EQ(person.labels[v], ScannedPerson::kOutlier);
}

TEST(DamageMesh, EmptyTrianglesHaveNoArea) {
  const SurfacedPerson person = damaged({.empty = 12});
  const Mesh& mesh = person.mesh;
  EXPECT_EQ(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                          [&](const Triangle& t) { return area(mesh, t) == 0; }),
            12);
}

TEST(DamageMesh, RefusesNumbersOutOfRange) {
  EXPECT_THROW(MeshDamageOptions{.turned = -1}.check(), InvalidInput);
  EXPECT_THROW(MeshDamageOptions{.split = 10001}.check(), InvalidInput);
  EXPECT_THROW(MeshDamageOptions{.fins = -1}.check(), InvalidInput);
  EXPECT_THROW(MeshDamageOptions{.empty = -1}.check(), InvalidInput);
  SurfacedPerson nobody;
  Random random(1);
  damage_mesh({.turned = 3, .fins = 3}, random, nobody);
  EXPECT_TRUE(nobody.mesh.triangles.empty());
}

}  // namespace
}  // namespace regarment
