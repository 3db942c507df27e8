#include "fit/person_outline.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

/// An upright box about the y axis, from `low` to `high`.
Mesh box(double width, double low, double high) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.emplace_back((corner & 1) != 0 ? width / 2 : -width / 2,
                                (corner & 2) != 0 ? high : low,
                                (corner & 4) != 0 ? width / 2 : -width / 2);
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

TEST(PersonOutline, AGarmentIsJudgedByTheAreaOfEitherAlone) {
  const PersonOutline person = outline_person(box(0.4, 0.0, 1.6), {}, 0, 512);
  ASSERT_EQ(person.silhouettes.size(), 4U);
  // Within the person: three times its own area is the person's alone, on each of four sides.
  const Mesh belt = box(0.4, 0.6, 1.0);
  const auto within = silhouette_error(person, belt.triangles, belt.positions);
  ASSERT_TRUE(within.has_value());
  EXPECT_NEAR(*within, 4 * 3.0, 0.15);  // a row of pixels at either end
  // Twice as wide: half of it is its own, 1.2 m of the person are not covered.
  const Mesh wide = box(0.8, 0.6, 1.0);
  EXPECT_NEAR(silhouette_error(person, wide.triangles, wide.positions).value_or(0), 4 * 2.0, 0.15);
}

TEST(PersonOutline, OfAGarmentOutsideOfThePictureThereIsNone) {
  const PersonOutline person = outline_person(box(0.4, 0.0, 1.6), {}, 0, 128);
  const Mesh far = box(0.4, 50.0, 51.0);
  EXPECT_FALSE(silhouette_error(person, far.triangles, far.positions).has_value());
}

TEST(PersonOutline, RefusesAPersonThatIsMaskedAway) {
  EXPECT_THROW(outline_person(box(0.4, 0, 1.6), std::vector<std::uint8_t>(12, 1), 0, 64),
               InvalidInput);
}

}  // namespace
}  // namespace regarment
