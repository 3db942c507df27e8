#include "garment/worn_normals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "garment/find_template.h"

namespace regarment {
namespace {

// A skirt wrapped round a tube: front and back panel each take half of it.
std::vector<Vec3> round_tube(const Pattern& skirt, double girth) {
  const double radius = girth / (2 * std::numbers::pi);
  std::vector<Vec3> out(static_cast<std::size_t>(skirt.particle_count));
  for (std::size_t v = 0; v < skirt.flat.size(); ++v) {
    const bool front = skirt.panel_is_front[static_cast<std::size_t>(skirt.panel[v])];
    const double angle = skirt.flat[v].x() / radius;
    out[static_cast<std::size_t>(skirt.particle[v])] =
        Vec3(radius * std::sin(angle), -skirt.flat[v].y(),
             (front ? 1.0 : -1.0) * radius * std::cos(angle));
  }
  return out;
}

TEST(WornNormals, PointAwayFromTheAxisOfATube) {
  const GarmentTemplate garment = find_template("skirt");
  Dimensions dimensions = garment.typical();
  for (const auto* name : {"waist", "hip", "width"}) dimensions[name] = 1.0;
  const Pattern skirt = make_pattern(garment, dimensions, 0.02);
  const std::vector<Vec3> x = round_tube(skirt, 1.0);
  const std::vector<Vec3> normals = worn_normals(skirt, x);
  ASSERT_EQ(normals.size(), x.size());
  for (std::size_t p = 0; p < x.size(); ++p) {
    const Vec3 outward = Vec3(x[p].x(), 0, x[p].z()).normalized();
    EXPECT_GT(normals[p].dot(outward), 0.99) << p;
    EXPECT_NEAR(normals[p].norm(), 1, 1e-12) << p;
  }
}

TEST(WornNormals, AreZeroWhereTheClothIsCrushedToAPoint) {
  const GarmentTemplate garment = find_template("skirt");
  const Pattern skirt = make_pattern(garment, garment.typical(), 0.1);
  const std::vector<Vec3> x(static_cast<std::size_t>(skirt.particle_count), Vec3(1, 2, 3));
  for (const Vec3& normal : worn_normals(skirt, x)) EXPECT_EQ(normal, Vec3::Zero());
}

}  // namespace
}  // namespace regarment
