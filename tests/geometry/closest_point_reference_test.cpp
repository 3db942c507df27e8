// The tree against asking every triangle or point, and against CGAL's tree.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/closest_point.h"
#include "support/dice.h"

namespace regarment {
namespace {

using test::Dice;

Vec3 random_point(Dice& dice, double size = 1) {
  return {dice.uniform(-size, size), dice.uniform(-size, size), dice.uniform(-size, size)};
}

/// The nearest point of a triangle by the region the query is in (Ericson 2005, 5.1.5).
Vec3 nearest_on(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = ab.dot(p - a), d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = ab.dot(p - b), d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
  return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac;
}

Vec3 normal_of(const Mesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vec3& origin = mesh.positions[a];
  return (mesh.positions[b] - origin).cross(mesh.positions[c] - origin).normalized();
}

/// Squared distance to the nearest allowed element, asked one by one; infinity when none is.
double brute_force(const Mesh& mesh, const std::vector<std::uint8_t>& masked, const Vec3& query,
                   const ClosestFilter& filter) {
  double best = std::numeric_limits<double>::infinity();
  const std::size_t count = mesh.is_cloud() ? mesh.positions.size() : mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!masked.empty() && masked[i] != 0) continue;
    const Vec3 normal = mesh.is_cloud() ? mesh.normals[i] : normal_of(mesh, i);
    const bool faces = !normal.isZero(0) && normal.dot(filter.normal) >= filter.min_cosine;
    if (filter.min_cosine > -1 && !faces) continue;
    Vec3 point = mesh.positions[std::min(i, mesh.positions.size() - 1)];
    if (!mesh.is_cloud()) {
      const auto& [a, b, c] = mesh.triangles[i];
      point = nearest_on(query, mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
    best = std::min(best, (point - query).squaredNorm());
  }
  return best <= filter.max_distance * filter.max_distance
             ? best
             : std::numeric_limits<double>::infinity();
}

/// Triangles of all sizes that know nothing of each other, some of them slivers.
Mesh random_soup(std::size_t count, std::uint64_t seed) {
  Dice dice(seed);
  Mesh mesh;
  for (std::uint32_t t = 0; t < count; ++t) {
    const double size = std::pow(10, dice.uniform(-2.5, 0));
    const Vec3 a = random_point(dice), b = a + random_point(dice, size);
    Vec3 c = a + random_point(dice, size);
    if (t % 5 == 0) c = a + dice.uniform(0, 1) * (b - a) + random_point(dice, 1e-7 * size);
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

/// A unit sphere of squares cut in two, around `centre`.
Mesh sphere(int rings, const Vec3& centre = Vec3::Zero()) {
  Mesh mesh;
  const auto columns = static_cast<std::uint32_t>(2 * rings);
  for (int i = 0; i <= rings; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double up = M_PI * i / rings, round = 2 * M_PI * j / columns;
      mesh.normals.emplace_back(std::sin(up) * std::cos(round), std::cos(up),
                                std::sin(up) * std::sin(round));
      mesh.positions.push_back(centre + mesh.normals.back());
    }
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rings); ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const std::uint32_t k = (j + 1) % columns, row = i * columns, next = row + columns;
      if (i > 0) mesh.triangles.push_back({row + j, row + k, next + k});
      if (i + 1 < static_cast<std::uint32_t>(rings))
        mesh.triangles.push_back({row + j, next + k, next + j});
    }
  }
  return mesh;
}

Mesh random_cloud(std::size_t count, std::uint64_t seed) {
  Dice dice(seed);
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 p = random_point(dice);
    if (i % 3 == 0) p = (p * 4).array().round() / 4;  // many coincide
    mesh.positions.push_back(p);
    mesh.normals.push_back(i % 7 == 0 ? Vec3::Zero() : random_point(dice).normalized());
  }
  return mesh;
}

template <class Tree>
Tree make_tree(const Mesh& mesh, const std::vector<std::uint8_t>& masked) {
  if (mesh.is_cloud()) return Tree(std::span(mesh.positions), std::span(mesh.normals), masked);
  return Tree(std::span(mesh.positions), std::span(mesh.triangles), masked);
}

std::vector<ClosestFilter> filters(Dice& dice) {
  std::vector<ClosestFilter> all(1);
  all.push_back({.max_distance = 0.1});
  for (const double cosine : {-0.7, 0.5, 0.95})
    all.push_back({.normal = random_point(dice).normalized(), .min_cosine = cosine});
  all.push_back({.max_distance = 0.3, .normal = Vec3::UnitY(), .min_cosine = 0.2});
  return all;
}

/// `unit`: what rounding is measured by besides the distance, for scenes far from the origin.
template <class Tree>
void expect_as_brute_force(const Mesh& mesh, const std::vector<std::uint8_t>& masked,
                           const Vec3& centre = Vec3::Zero(), double unit = 1) {
  const Tree tree = make_tree<Tree>(mesh, masked);
  Dice dice(17);
  for (int i = 0; i < 60; ++i) {
    const double reach = i % 4 == 0 ? 20 : 1.1;
    const Vec3 query = centre + random_point(dice, reach);
    for (const ClosestFilter& filter : filters(dice)) {
      const double truth = brute_force(mesh, masked, query, filter);
      const ClosestHit hit = tree.closest(query, filter);
      ASSERT_EQ(hit.found(), std::isfinite(truth));
      if (!hit.found()) continue;
      // Rounding of coordinates of size `unit`, and slivers a ten-millionth as wide as long.
      const double tolerance = 1e-14 * unit + 1e-12;
      EXPECT_NEAR(std::sqrt(hit.squared_distance), std::sqrt(truth), tolerance);
      EXPECT_DOUBLE_EQ((hit.point - query).squaredNorm(), hit.squared_distance);
      EXPECT_TRUE(masked.empty() || masked[hit.element] == 0);
      if (filter.min_cosine > -1) {
        EXPECT_GE(hit.normal.dot(filter.normal), filter.min_cosine);
      }
    }
  }
}

template <class K>
class ClosestPointReference : public testing::Test {
 public:
  using Tree = KDopTree<K::value>;
};
using AllK = testing::Types<std::integral_constant<int, 6>, std::integral_constant<int, 14>,
                            std::integral_constant<int, 18>, std::integral_constant<int, 26>>;
TYPED_TEST_SUITE(ClosestPointReference, AllK);

TYPED_TEST(ClosestPointReference, FindsWhatBruteForceFindsInASoup) {
  for (const std::size_t count : {1u, 3u, 4u, 5u, 17u, 400u})
    expect_as_brute_force<typename TestFixture::Tree>(random_soup(count, count), {});
}

TYPED_TEST(ClosestPointReference, FindsWhatBruteForceFindsOnASphere) {
  expect_as_brute_force<typename TestFixture::Tree>(sphere(16), {});
}

TYPED_TEST(ClosestPointReference, FindsWhatBruteForceFindsInACloud) {
  for (const std::size_t count : {1u, 8u, 9u, 700u})
    expect_as_brute_force<typename TestFixture::Tree>(random_cloud(count, count), {});
}

TYPED_TEST(ClosestPointReference, PassesOverMaskedElements) {
  for (const Mesh& mesh : {random_soup(300, 5), random_cloud(300, 6)}) {
    std::vector<std::uint8_t> masked(300);
    for (std::size_t i = 0; i < masked.size(); ++i) masked[i] = i % 3 != 0;
    expect_as_brute_force<typename TestFixture::Tree>(mesh, masked);
  }
}

TYPED_TEST(ClosestPointReference, IsExactFarFromTheOrigin) {
  const Vec3 centre(4e5, -3e5, 2e5);
  expect_as_brute_force<typename TestFixture::Tree>(sphere(12, centre), {}, centre, 5e5);
}

TYPED_TEST(ClosestPointReference, IsExactBesideStrays) {
  // Asked near the sphere, where the strays must not cost a digit, and from beside the strays.
  Mesh mesh = sphere(8);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const double far : {1e3, 1e9}) {
    mesh.positions.insert(mesh.positions.end(),
                          {Vec3(far, 0, 0), Vec3(far, 1, 0), Vec3(far, 0, 1)});
    mesh.normals.insert(mesh.normals.end(), 3, Vec3::UnitX());
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first + 3, first + 4, first + 5});
  mesh.triangles.push_back({0, first, first + 3});  // from the sphere past all of them
  expect_as_brute_force<typename TestFixture::Tree>(mesh, {});
  expect_as_brute_force<typename TestFixture::Tree>(mesh, {}, Vec3(1e9, 0.3, 0.2), 1e9);
  mesh.triangles.clear();
  expect_as_brute_force<typename TestFixture::Tree>(mesh, {});
  expect_as_brute_force<typename TestFixture::Tree>(mesh, {}, Vec3(1e9, 0.3, 0.2), 1e9);
}

TYPED_TEST(ClosestPointReference, IsExactAmongElementsOfAllSizes) {
  // Each point half as far out as the one before: a tree that halves space is 900 levels deep.
  Mesh mesh;
  for (int i = 0; i < 900; ++i) {
    mesh.positions.emplace_back(std::pow(0.5, i), 0, 0);
    mesh.normals.push_back(Vec3::UnitX());
  }
  expect_as_brute_force<typename TestFixture::Tree>(mesh, {});
}

TYPED_TEST(ClosestPointReference, AgreesWithCgal) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  const Mesh mesh = sphere(40);
  const auto corner = [&](std::uint32_t v) {
    const Vec3& p = mesh.positions[v];
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  Triangles triangles;
  for (const auto& [a, b, c] : mesh.triangles)
    triangles.emplace_back(corner(a), corner(b), corner(c));
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> cgal(triangles.begin(),
                                                                   triangles.end());
  const auto tree = make_tree<typename TestFixture::Tree>(mesh, {});
  Dice dice(3);
  for (int i = 0; i < 500; ++i) {
    const Vec3 query = random_point(dice, 2);
    const double theirs =
        std::sqrt(cgal.squared_distance(Kernel::Point_3(query.x(), query.y(), query.z())));
    const double ours = std::sqrt(tree.closest(query).squared_distance);
    // Relative to the distance, but for the rounding of coordinates, 2e-16, near the surface.
    EXPECT_NEAR(ours, theirs, 1e-12 * theirs + 1e-15);
  }
}

}  // namespace
}  // namespace regarment
