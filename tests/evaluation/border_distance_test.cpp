#include "evaluation/border_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/error.h"
#include "base/random.h"

namespace regarment {
namespace {

// A strip of `columns` x 3 vertices a millimetre apart, as a mesh or as the points alone.
Mesh strip(std::uint32_t columns, bool triangles) {
  Mesh mesh;
  for (std::uint32_t x = 0; x < columns; ++x) {
    for (std::uint32_t y = 0; y < 3; ++y) mesh.positions.emplace_back(0.001 * x, 0.001 * y, 0);
  }
  for (std::uint32_t x = 0; triangles && x + 1 < columns; ++x) {
    for (std::uint32_t y = 0; y < 2; ++y) {
      const std::uint32_t a = 3 * x + y;
      mesh.triangles.push_back({a, a + 3, a + 1});
      mesh.triangles.push_back({a + 3, a + 4, a + 1});
    }
  }
  return mesh;
}

// 1 from this column on.
std::vector<std::uint8_t> from_column(std::uint32_t columns, std::uint32_t first) {
  std::vector<std::uint8_t> labels;
  for (std::uint32_t x = 0; x < columns; ++x) labels.insert(labels.end(), 3, x >= first ? 1 : 0);
  return labels;
}

TEST(BorderDistance, IsZeroForEqualLabels) {
  const auto labels = from_column(20, 8);
  EXPECT_EQ(border_distance(strip(20, true), labels, labels), 0.0);
  EXPECT_EQ(border_distance(strip(20, false), labels, labels), 0.0);
}

TEST(BorderDistance, IsTheShiftOfAStraightBorder) {
  const auto found = from_column(30, 15), real = from_column(30, 10);
  EXPECT_NEAR(border_distance(strip(30, true), found, real).value(), 0.005, 1e-12);
  // The border of a cloud is a band, here as wide as two points are apart.
  EXPECT_NEAR(border_distance(strip(30, false), found, real).value(), 0.005, 0.001);
}

TEST(BorderDistance, IsTheSameBothWays) {
  const auto a = from_column(30, 7), b = from_column(30, 22);
  const Mesh mesh = strip(30, true);
  EXPECT_EQ(border_distance(mesh, a, b), border_distance(mesh, b, a));
}

TEST(BorderDistance, IsNotThereWithoutABorder) {
  const std::vector<std::uint8_t> plain(60, 0);
  EXPECT_FALSE(border_distance(strip(20, true), plain, from_column(20, 8)));
  EXPECT_FALSE(border_distance(strip(20, true), from_column(20, 8), plain));
}

TEST(BorderDistance, LeavesOutWhatIsNotScored) {
  auto truth = from_column(30, 10);
  for (std::size_t i = 3 * 20; i < truth.size(); ++i) truth[i] = 255;
  auto labels = from_column(30, 10);
  for (std::size_t i = 3 * 25; i < labels.size(); ++i) labels[i] = 0;  // a second border, unscored
  EXPECT_EQ(border_distance(strip(30, true), labels, truth), 0.0);
}

TEST(BorderDistance, RefusesLabelsOfAnotherScan) {
  EXPECT_THROW(border_distance(strip(20, true), from_column(19, 3), from_column(20, 3)),
               InvalidInput);
}

// Every pair and every distance looked at.
double by_brute_force(const Mesh& mesh, const std::vector<std::uint8_t>& labels,
                      const std::vector<std::uint8_t>& truth) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  const auto border = [&](const std::vector<std::uint8_t>& of) {
    std::vector<Vec3> points;
    for (const auto& [a, b] : edges) {
      if (of[a] != of[b]) points.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
    }
    return points;
  };
  const auto mean = [](const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    double sum = 0;
    for (const Vec3& p : from) {
      double nearest = 1e9;
      for (const Vec3& q : to) nearest = std::min(nearest, (p - q).norm());
      sum += nearest;
    }
    return sum / static_cast<double>(from.size());
  };
  const auto found = border(labels), real = border(truth);
  return (mean(found, real) + mean(real, found)) / 2;
}

TEST(BorderDistance, AgreesWithBruteForce) {
  Random random(11);
  Mesh mesh = strip(40, true);
  for (Vec3& p : mesh.positions)
    p += 0.0002 * Vec3(random.normal(), random.normal(), random.normal());
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::uint8_t> labels, truth;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      labels.push_back(static_cast<std::uint8_t>(3 * random.uniform()));
      truth.push_back(random.uniform() < 0.9 ? 0 : 2);
    }
    EXPECT_NEAR(border_distance(mesh, labels, truth).value(), by_brute_force(mesh, labels, truth),
                1e-12);
  }
}

TEST(Neighbours, OfACloudAreTheSixNearest) {
  const Mesh mesh = strip(9, false);
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    std::vector<std::pair<double, std::uint32_t>> order;
    for (std::uint32_t k = 0; k < mesh.positions.size(); ++k) {
      if (k != i) order.emplace_back((mesh.positions[k] - mesh.positions[i]).norm(), k);
    }
    std::sort(order.begin(), order.end());
    // Where the seventh is as far as the sixth the choice is open; the strip has such points.
    if (order[5].first > order[6].first - 1e-9) continue;
    for (std::size_t k = 0; k < 6; ++k) expected.insert(std::minmax(i, order[k].second));
  }
  const auto pairs = neighbours(mesh);
  ASSERT_FALSE(expected.empty());
  for (const auto& pair : expected) {
    EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), pair))
        << pair.first << " " << pair.second;
  }
  EXPECT_LE(pairs.size(), 6 * mesh.positions.size());
}

}  // namespace
}  // namespace regarment
