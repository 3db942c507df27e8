#include "fill/fill_cloud.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "sheets.h"

namespace regarment {
namespace {

using test::sheet;

Mesh flat_cloth() {
  Mesh cloth = sheet(10, 0.1);
  cloth.normals.assign(cloth.positions.size(), Vec3::UnitZ());
  return cloth;
}

std::vector<EdgeLoop> rim() {
  return {EdgeLoop({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)})};
}

std::vector<Vec3> grid_without(const std::function<bool(double, double)>& missing) {
  std::vector<Vec3> out;
  for (const Vec3& p : sheet(100, 0.01).positions)
    if (!missing(p.x(), p.y())) out.push_back(p);
  return out;
}

TEST(FillCloud, FillsASquareThatIsMissing) {
  const auto missing = [](double x, double y) { return x > 0.4 && x < 0.6 && y > 0.4 && y < 0.6; };
  const std::vector<Vec3> added = fill_cloud(grid_without(missing), flat_cloth(), rim(), 0.01);
  for (const Vec3& p : added) EXPECT_TRUE(missing(p.x(), p.y())) << p.transpose();
  // 14 x 14 cm lie 3 cm and more from every point; a point of the cloud has a square centimetre.
  EXPECT_NEAR(static_cast<double>(added.size()), 196, 40);
}

TEST(FillCloud, LeavesTheGapsBetweenPoints) {
  EXPECT_TRUE(fill_cloud(grid_without([](double x, double y) {
                           return std::abs(x - 0.5) < 0.015 && std::abs(y - 0.5) < 0.015;
                         }),
                         flat_cloth(), rim(), 0.01)
                  .empty());
}

// The cloud ends 2.5 cm before the cloth's edge everywhere: the cloth is too long.
TEST(FillCloud, LeavesARimBesideTheEdge) {
  EXPECT_TRUE(fill_cloud(grid_without([](double x, double y) {
                           return std::min({x, y, 1 - x, 1 - y}) < 0.025;
                         }),
                         flat_cloth(), rim(), 0.01)
                  .empty());
}

TEST(FillCloud, NeedsASpacing) {
  EXPECT_THROW(fill_cloud({Vec3::Zero()}, flat_cloth(), rim(), 0), InvalidInput);
  EXPECT_TRUE(fill_cloud({}, flat_cloth(), rim(), 0.01).empty());
}

}  // namespace
}  // namespace regarment
