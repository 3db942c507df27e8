#include "synthetic/resting_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "made_sheets.h"

namespace regarment {
namespace {

constexpr double kGravity = 9.81;
constexpr double kPi = std::numbers::pi;

void rest(RestingSheet& moving, const std::vector<const Obstacle*>& obstacles,
          const RestOptions& options, int steps) {
  for (int i = 0; i < steps; ++i) moving.step(obstacles, options);
}

// Every level carries what hangs below it: the strip grows by density g L / (2 k).
TEST(RestingSheet, HangsAsLongAsHookeSays) {
  const int columns = 4, rows = 30;
  const double h = 0.02;
  const Pattern pattern = grid_pattern(columns, rows, h);
  for (const double stiffness : {40.0, 1500.0}) {
    SheetFabric fabric;
    fabric.stiffness_along = stiffness;
    const Sheet sheet = make_sheet(pattern, fabric);
    RestingSheet strip(sheet,
                       placed(pattern, [](const Vec2& p) { return Vec3(p.x(), -p.y(), 0); }));
    for (int i = 0; i <= columns; ++i) strip.pin(static_cast<std::size_t>(i));
    RestOptions options;
    options.self_contact = false;
    rest(strip, {}, options, 400);
    const double length = rows * h;
    const double low = strip.positions()[static_cast<std::size_t>((columns + 1) * rows)].y();
    const double expected = fabric.density * kGravity * length * length / (2 * stiffness);
    EXPECT_NEAR(-low - length, expected, 0.02 * expected) << stiffness << " N/m";
  }
}

// A strip clamped at one end sags by q L^4 / (8 B) at the other, q being its weight by area; and by
// q L^3 a / (4 B) more, because the whole row of width a at the clamp bends, not half of it.
TEST(RestingSheet, SagsAsABeamDoes) {
  const int columns = 48, rows = 24;
  const double h = 0.005;
  const Pattern pattern = lattice_pattern(columns, rows, h);
  SheetFabric fabric;
  fabric.bending = 8e-3;
  const Sheet sheet = make_sheet(pattern, fabric);
  RestingSheet beam(sheet, placed(pattern, [](const Vec2& p) { return Vec3(p.x(), 0, p.y()); }));
  // Two rows hold it level.
  for (std::size_t p = 0; p < 2 * (columns + 1); ++p) beam.pin(p);
  RestOptions options;
  options.self_contact = false;
  options.iterations = 10;
  rest(beam, {}, options, 300);
  const double row = h * std::sqrt(0.75), length = (rows - 1) * row;
  const double weight = fabric.density * kGravity;
  const double expected = weight * std::pow(length, 3) * (length / 8 + row / 4) / fabric.bending;
  ASSERT_LT(expected, 0.1 * length);  // small enough for the formula
  const double sag =
      -beam.positions()[static_cast<std::size_t>((columns + 1) * rows + columns / 2)].y();
  EXPECT_NEAR(sag, expected, 0.05 * expected);
}

/// A cone of cloth: particles on rings, one panel cut out of the plane, its two straight sides
/// sewn. The angle between axis and side is `half_angle`, rings lie `upper` to `lower` m from the
/// tip along the side.
struct MadeCone {
  Pattern pattern;
  std::vector<Vec3> positions;

  MadeCone(double half_angle, double upper, double lower, int around, int rings) {
    pattern.panel_names = {"cone"};
    pattern.panel_limbs = {"torso"};
    pattern.panel_is_front = {true};
    pattern.particle_count = around * (rings + 1);
    const double sector = 2 * kPi * std::sin(half_angle);
    positions.resize(static_cast<std::size_t>(pattern.particle_count));
    for (int j = 0; j <= rings; ++j)
      for (int i = 0; i <= around; ++i) {
        const double r = upper + (lower - upper) * j / rings;
        const double flat = sector * i / around, turn = 2 * kPi * i / around;
        const int particle = i % around + around * j;
        pattern.flat.emplace_back(r * std::sin(flat), r * std::cos(flat));
        pattern.particle.push_back(particle);
        pattern.panel.push_back(0);
        positions[static_cast<std::size_t>(particle)] =
            r * Vec3(std::sin(half_angle) * std::sin(turn), -std::cos(half_angle),
                     std::sin(half_angle) * std::cos(turn));
      }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i + (around + 1) * j); };
    for (int j = 0; j < rings; ++j)
      for (int i = 0; i < around; ++i) {
        pattern.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
        pattern.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      }
  }
};

// A skirt on a smooth cone slides until the tension round it carries its weight W. Lowered by d
// along the side it is stretched by d / r at r from the tip, and for a fabric alike in every
// direction virtual work gives k d 2 pi sin(a) ln(lower / upper) = W cos(a).
TEST(RestingSheet, SlidesDownAConeUntilItCarriesItsWeight) {
  const double half_angle = 0.5, upper = 0.25, lower = 0.45;
  SheetFabric fabric;
  fabric.stiffness_along = fabric.stiffness_across = 60;
  fabric.stiffness_shear = 30;  // with this it is the same in every direction
  fabric.friction = 0;
  fabric.bending = 0;
  const MadeCone cone(half_angle, upper, lower, 72, 10);
  const Sheet sheet = make_sheet(cone.pattern, fabric);
  // The obstacle is the same cone, longer at both ends, further in by the cloth's distance from
  // it, and with corners where the cloth has its own.
  const MadeCone solid(half_angle, 0.15, 0.7, 72, 1);
  std::vector<Vec3> skin = solid.positions;
  const double touch = fabric.thickness / 2 + 0.001;  // half the cloth and the air below it
  for (Vec3& p : skin) p.y() -= touch / std::sin(half_angle);
  std::vector<Triangle> triangles;
  for (const Triangle& t : solid.pattern.triangles)
    triangles.push_back({static_cast<std::uint32_t>(solid.pattern.particle[t[0]]),
                         static_cast<std::uint32_t>(solid.pattern.particle[t[1]]),
                         static_cast<std::uint32_t>(solid.pattern.particle[t[2]])});
  const Obstacle obstacle(ObstacleKind::Body, triangles, skin, 0.0);
  RestingSheet skirt(sheet, cone.positions);
  RestOptions options;
  options.self_contact = false;
  options.pressure = 1e7;
  options.air = 5;
  rest(skirt, {&obstacle}, options, 1200);
  double weight = 0, lowered = 0;
  for (const double m : sheet.mass) weight += kGravity * m;
  for (std::size_t p = 0; p < cone.positions.size(); ++p)
    lowered += (cone.positions[p].y() - skirt.positions()[p].y()) / std::cos(half_angle) /
               static_cast<double>(cone.positions.size());
  const double expected =
      weight * std::cos(half_angle) /
      (fabric.stiffness_along * 2 * kPi * std::sin(half_angle) * std::log(lower / upper));
  EXPECT_NEAR(lowered, expected, 0.08 * expected);
}

TEST(RestingSheet, RefusesOtherThanOnePositionPerParticle) {
  const Pattern pattern = grid_pattern(2, 2, 0.02);
  const Sheet sheet = make_sheet(pattern, {});
  EXPECT_ANY_THROW(RestingSheet(sheet, std::vector<Vec3>(4, Vec3::Zero())));
}

}  // namespace
}  // namespace regarment
