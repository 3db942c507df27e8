#include "synthetic/reconstruct.h"

#include <gtest/gtest.h>

#include <map>

#include "base/error.h"
#include "scanner_figures.h"
#include "synthetic/reconstruct_field.h"
#include "synthetic/reconstruct_surface.h"

namespace regarment {
namespace {

const Vec3 kCentre(0, 1, 0);
constexpr double kRadius = 0.15;  // m

/// Points about 4 mm apart on the ball, as exact as doubles are; label 1 on the upper half.
ScannedPerson ball_points(double noise = 0) {
  ScannedPerson scan;
  Random random(3);
  const Mesh mesh = test::ball(kCentre, kRadius, 100);
  for (const Vec3& p : mesh.positions) {
    const Vec3 normal = (p - kCentre).normalized();
    scan.cloud.positions.push_back(p + noise * random.normal() * normal);
    scan.cloud.normals.push_back(normal);
    scan.labels.push_back(p.y() > kCentre.y() ? 1 : 0);
    scan.particle.push_back(ScannedPerson::kNone);
  }
  return scan;
}

void keep_where(ScannedPerson& scan, const std::function<bool(const Vec3&)>& wanted) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < scan.labels.size(); ++i)
    if (wanted(scan.cloud.positions[i])) kept.push_back(i);
  keep_points(scan, kept);
}

/// Every directed edge has its opposite.
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      ++balance[{t[k], t[(k + 1) % 3]}];
      --balance[{t[(k + 1) % 3], t[k]}];
    }
  return std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
  return sum;
}

constexpr double kBallVolume = 4.0 / 3 * std::numbers::pi * kRadius * kRadius * kRadius;

TEST(Reconstruct, ZeroSurfaceOfABallsDistanceIsTheBall) {
  DistanceField field;
  field.cell = 0.01;
  field.size = {40, 41, 42};
  field.origin = kCentre - Vec3(0.2, 0.203, 0.206);
  for (int z = 0; z < 42; ++z)
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 40; ++x)
        field.value.push_back(static_cast<float>(
            (field.origin + field.cell * Vec3(x, y, z) - kCentre).norm() - kRadius));
  const Mesh mesh = zero_surface(field);
  EXPECT_TRUE(is_closed(mesh));
  // Crossings lie on the ball, at most half a cell's diagonal from their mean, which so is within
  // it by at most 3 cell^2 / (8 radius).
  for (const Vec3& p : mesh.positions) EXPECT_NEAR((p - kCentre).norm(), kRadius, 2.5e-4);
  EXPECT_NEAR(volume(mesh), kBallVolume, 0.005 * kBallVolume);
}

TEST(Reconstruct, BallComesBackFromItsPoints) {
  const SurfacedPerson ball = reconstruct_closed(ball_points(0.0003), {});
  EXPECT_TRUE(is_closed(ball.mesh));
  for (const Vec3& p : ball.mesh.positions) EXPECT_NEAR((p - kCentre).norm(), kRadius, 0.0008);
  EXPECT_NEAR(volume(ball.mesh), kBallVolume, 0.01 * kBallVolume);
}

TEST(Reconstruct, HoleIsClosedAndCalledInvented) {
  ScannedPerson scan = ball_points();
  const double cut = kCentre.y() + 0.12;  // a cap of radius 9 cm is missing
  keep_where(scan, [&](const Vec3& p) { return p.y() < cut; });
  const SurfacedPerson closed = reconstruct_closed(scan, {});
  EXPECT_TRUE(is_closed(closed.mesh));
  std::size_t invented = 0;
  for (std::size_t v = 0; v < closed.labels.size(); ++v) {
    double nearest = 1;
    for (const Vec3& p : scan.cloud.positions)
      nearest = std::min(nearest, (p - closed.mesh.positions[v]).norm());
    ASSERT_EQ(closed.labels[v] == ScannedPerson::kOutlier, nearest > ReconstructOptions{}.invented);
    invented += nearest > ReconstructOptions{}.invented;
  }
  // A flat disc would have 700 cells; the cap bulges a little.
  EXPECT_GT(invented, 400U);
}

TEST(Reconstruct, OpenSurfaceEndsWithTheData) {
  ScannedPerson scan = ball_points();
  const double cut = kCentre.y() + 0.12;
  keep_where(scan, [&](const Vec3& p) { return p.y() < cut; });
  ReconstructOptions options;
  const SurfacedPerson open = reconstruct_open(scan, options);
  EXPECT_FALSE(is_closed(open.mesh));
  double top = 0;
  for (const Vec3& p : open.mesh.positions) {
    double nearest = 1;
    for (const Vec3& q : scan.cloud.positions) nearest = std::min(nearest, (p - q).norm());
    ASSERT_LE(nearest, options.open_reach);
    top = std::max(top, p.y());
  }
  EXPECT_GT(top, cut - options.cell);
}

TEST(Reconstruct, FlatCutTakesOnePartAndLeavesAFlatBorder) {
  Mesh mesh = test::ball(kCentre, kRadius);
  const Mesh other = test::ball(kCentre + Vec3(1, 0, 0), kRadius);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  const double height = 0.0503;  // of the cut above the middle; no ring lies there
  cut_flat({kCentre + Vec3(0, height, 0), Vec3::UnitY(), 0.2}, mesh);
  // What is left of the first ball, closed by a flat disc, is the ball without a cap.
  double volume_left = 0, top_of_other = 0;
  std::size_t in_plane = 0;
  for (const Vec3& p : mesh.positions) {
    if (p.x() > 0.5) top_of_other = std::max(top_of_other, p.y());
    if (p.x() < 0.5) {
      ASSERT_LE(p.y(), kCentre.y() + height + 1e-12);
    }
    in_plane += p.x() < 0.5 && p.y() > kCentre.y() + height - 1e-12;
  }
  const Vec3 apex = kCentre + Vec3(0, height, 0);  // cones from a point of the disc: it adds none
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]] - apex, b = mesh.positions[t[1]] - apex,
               c = mesh.positions[t[2]] - apex;
    if (mesh.positions[t[0]].x() < 0.5) volume_left += a.dot(b.cross(c)) / 6;
  }
  const double cap_height = kRadius - height;
  const double cap = std::numbers::pi * cap_height * cap_height * (3 * kRadius - cap_height) / 3;
  EXPECT_NEAR(volume_left, kBallVolume - cap, 0.004 * kBallVolume);
  EXPECT_GE(in_plane, 120U);
  EXPECT_NEAR(top_of_other, kCentre.y() + kRadius, 1e-12);
}

TEST(Reconstruct, VerticesTakeLabelAndColourOfTheirPoints) {
  ScannedPerson scan = ball_points();
  for (const std::uint8_t label : scan.labels)
    scan.cloud.colours.push_back(label == 1 ? Colour{200, 10, 20} : Colour{30, 40, 250});
  const SurfacedPerson ball = reconstruct_closed(scan, {});
  for (std::size_t v = 0; v < ball.labels.size(); ++v) {
    const double above = ball.mesh.positions[v].y() - kCentre.y();
    if (std::abs(above) < 0.01) continue;  // eight points reach about 7 mm
    EXPECT_EQ(ball.labels[v], above > 0 ? 1 : 0);
    EXPECT_EQ(ball.mesh.colours[v], above > 0 ? (Colour{200, 10, 20}) : (Colour{30, 40, 250}));
  }
}

TEST(Reconstruct, SmallPiecesAreLeftOut) {
  ScannedPerson scan = ball_points();
  const Mesh crumb = test::ball(kCentre + Vec3(0.3, 0, 0), 0.012, 10);
  for (const Vec3& p : crumb.positions) {
    scan.cloud.positions.push_back(p);
    scan.cloud.normals.push_back((p - kCentre - Vec3(0.3, 0, 0)).normalized());
    scan.labels.push_back(ScannedPerson::kOutlier);
    scan.particle.push_back(ScannedPerson::kNone);
  }
  const auto has_crumb = [](const SurfacedPerson& person) {
    return std::any_of(person.mesh.positions.begin(), person.mesh.positions.end(),
                       [](const Vec3& p) { return p.x() > 0.25; });
  };
  EXPECT_FALSE(has_crumb(reconstruct_closed(scan, {})));
  ReconstructOptions options;
  options.least_piece = 0;
  EXPECT_TRUE(has_crumb(reconstruct_closed(scan, options)));
}

TEST(Reconstruct, ScannedBallComesBack) {
  DressedPerson person;
  person.body = test::ball(kCentre, kRadius);
  Random random(1);
  ScannerOptions options;
  options.rig.pixel = 0.004;
  const ScannedPerson scan = scan_person(person, options, random);
  const SurfacedPerson ball = reconstruct_closed(scan, {});
  // Noise of 0.5 mm and false places of 0.2 mm, averaged. Nothing is said near the poles, which
  // all cameras see at grazing angles.
  std::size_t good = 0, scored = 0;
  for (std::size_t v = 0; v < ball.labels.size(); ++v) {
    const Vec3 off = ball.mesh.positions[v] - kCentre;
    if (std::abs(off.y()) > 0.7 * kRadius) continue;
    ++scored;
    good += std::abs(off.norm() - kRadius) < 0.001;
  }
  EXPECT_GT(scored, 4000U);
  EXPECT_GT(100 * good, 99 * scored);
}

TEST(Reconstruct, SameBytesTwice) {
  const ScannedPerson scan = ball_points(0.001);
  const SurfacedPerson a = reconstruct_closed(scan, {}), b = reconstruct_closed(scan, {});
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.labels, b.labels);
}

TEST(Reconstruct, VastScansGetLargerCells) {
  // Two balls 40 m apart would need 10^9 nodes along one axis only: the grid stays within 2^24.
  const std::vector<Vec3> points{{0, 0, 0}, {40, 30, 20}}, normals{{0, 1, 0}, {0, 1, 0}};
  const DistanceField field = distance_field(points, normals, 0.006);
  EXPECT_GT(field.cell, 0.006);
  EXPECT_LE(field.nodes(), std::size_t{1} << 24);
}

TEST(Reconstruct, RefusesWhatMakesNoSurface) {
  EXPECT_THROW(reconstruct_closed({}, {}), InvalidInput);
  ScannedPerson scan = ball_points();
  scan.cloud.positions[5].x() = std::nan("");
  EXPECT_THROW(reconstruct_closed(scan, {}), InvalidInput);
  for (double ReconstructOptions::*field :
       {&ReconstructOptions::cell, &ReconstructOptions::invented,
        &ReconstructOptions::open_reach}) {
    ReconstructOptions options;
    options.*field = 0;
    EXPECT_THROW(options.check(), InvalidInput);
  }
}

}  // namespace
}  // namespace regarment
