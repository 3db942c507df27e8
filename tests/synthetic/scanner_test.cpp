#include "synthetic/scanner.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scanner_figures.h"

namespace regarment {
namespace {

constexpr double kBody = 0.10;   // m, radius of the column that stands for a person
constexpr double kHeight = 1.6;  // m

const test::ConeSkirt kSkirt{.waist = 0.80, .width = 1.20, .length = 0.50, .top = 1.0};

DressedPerson dressed(double edge_length = 0.01) {
  DressedPerson person;
  person.body = test::column(kBody, kHeight);
  person.garments.push_back(kSkirt.worn(edge_length, {}));
  return person;
}

ScannerOptions faultless() {
  ScannerOptions options;
  options.sensing.noise = options.sensing.calibration = options.sensing.dropout = 0;
  options.sensing.mixed = 0;
  options.rig.pixel = 0.006;
  return options;
}

ScannedPerson scanned(const DressedPerson& person, const ScannerOptions& options,
                      std::uint64_t seed = 1) {
  Random random(seed);
  return scan_person(person, options, random);
}

double radius_of(const Vec3& p) { return std::hypot(p.x(), p.z()); }

bool same(const ScannedPerson& a, const ScannedPerson& b) {
  return a.cloud.positions == b.cloud.positions && a.cloud.normals == b.cloud.normals &&
         a.cloud.colours == b.cloud.colours && a.labels == b.labels && a.particle == b.particle;
}

TEST(Scanner, LabelsAreThoseOfThePlace) {
  const ScannedPerson scan = scanned(dressed(), faultless());
  std::size_t skirt = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    const Vec3& p = scan.cloud.positions[i];
    const double r = radius_of(p);
    if (scan.labels[i] == 0) {
      ASSERT_LT(r, kBody + 1e-9);
    } else {
      ASSERT_EQ(scan.labels[i], 1);
      // Between the waist and the hem, on either side of the middle by half the thickness; facets
      // of 1 cm on a circle of 13 cm lie up to 0.1 mm within it.
      ASSERT_NEAR(r, kSkirt.radius(kSkirt.top - p.y()), 0.0013);
      ++skirt;
    }
  }
  EXPECT_GT(skirt, 5000U);
  EXPECT_GT(scan.labels.size() - skirt, 5000U);
}

TEST(Scanner, BodyUnderTheSkirtIsHidden) {
  const ScannedPerson scan = scanned(dressed(), faultless());
  // Rays fall at most atan((1.85 - 0.8) / 1.8) = 30 degrees from above and rise less from below.
  for (std::size_t i = 0; i < scan.labels.size(); ++i)
    if (scan.labels[i] == 0) {
      const double y = scan.cloud.positions[i].y();
      ASSERT_TRUE(y > kSkirt.top - 0.03 || y < kSkirt.top - kSkirt.length + 0.06) << y;
    }
}

TEST(Scanner, ParticlesAreTheNearestOnTheOuterSide) {
  const DressedPerson person = dressed();
  const ScannedPerson scan = scanned(person, faultless());
  const std::vector<Vec3>& particles = person.garments[0].particles;
  for (std::size_t i = 0; i < scan.labels.size(); i += 17) {
    if (scan.particle[i] == ScannedPerson::kNone) continue;
    ASSERT_EQ(scan.labels[i], 1);
    double nearest = 1;
    for (const Vec3& p : particles)
      nearest = std::min(nearest, (p - scan.cloud.positions[i]).norm());
    // The nearest corner of the triangle, and few of a triangle's points are nearer to another.
    ASSERT_LT((particles[scan.particle[i]] - scan.cloud.positions[i]).norm(), nearest + 0.002);
  }
}

TEST(Scanner, SeenParticlesAreThoseNothingHides) {
  DressedPerson person = dressed();
  // A wider skirt over the upper half hides waist and upper half of the first; below it all is
  // seen but the shadow of its hem.
  const test::ConeSkirt over{.waist = 0.90, .width = 1.10, .length = 0.25, .top = 1.01};
  person.garments.insert(person.garments.begin(), over.worn(0.01, {}));
  ScannerOptions options = faultless();
  options.rig.pixel = 0.003;  // several in the half centimetre nearest to a particle of the hem
  const ScannedPerson scan = scanned(person, options);
  const std::vector<Vec3>& particles = person.garments[1].particles;
  const auto seen = seen_particles(scan, 2, particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles[i].y() < 0.66) {
      EXPECT_EQ(seen[i], 1) << particles[i].transpose();
    }
    if (particles[i].y() > 0.79 && particles[i].y() < 0.97) {
      EXPECT_EQ(seen[i], 0) << particles[i].transpose();
    }
  }
}

TEST(Scanner, SameSeedSamePoints) {
  ScannerOptions options = faultless();
  options.sensing = {};
  options.props = {.posts = 1, .floor_radius = 0.4, .islands = 2};
  const DressedPerson person = dressed();
  const ScannedPerson first = scanned(person, options);
  EXPECT_TRUE(same(first, scanned(person, options)));
  EXPECT_FALSE(same(first, scanned(person, options, 2)));
}

// Sensors run on as many threads as there are, so the others' points must not depend on what one
// sensor has drawn.
TEST(Scanner, MissingColumnTakesItsOwnPointsAlone) {
  ScannerOptions options = faultless();
  options.sensing = {};
  const DressedPerson person = dressed();
  const ScannedPerson all = scanned(person, options);
  options.rig.missing = {0};
  const ScannedPerson without = scanned(person, options);
  ASSERT_LT(7 * without.labels.size(), 6 * all.labels.size());
  const std::size_t gone = all.labels.size() - without.labels.size();
  std::vector<std::uint32_t> others;
  for (std::size_t i = gone; i < all.labels.size(); ++i)
    others.push_back(static_cast<std::uint32_t>(i));
  ScannedPerson rest = all;
  keep_points(rest, others);
  EXPECT_TRUE(same(rest, without));
}

TEST(Scanner, PropsAreNobodys) {
  ScannerOptions options = faultless();
  options.props = {.posts = 2, .floor_radius = 0.5, .islands = 5};
  const ScannedPerson scan = scanned(dressed(), options);
  std::size_t floor = 0, far = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    const Vec3& p = scan.cloud.positions[i];
    if (p.y() < 1e-6 && radius_of(p) > kBody + 1e-3) {
      ASSERT_EQ(scan.labels[i], ScannedPerson::kOutlier);
      ++floor;
    }
    if (radius_of(p) > 0.55) {
      ASSERT_EQ(scan.labels[i], ScannedPerson::kOutlier);
      ++far;
    }
  }
  EXPECT_GT(floor, 1000U);
  EXPECT_GT(far, 500U);
}

TEST(Scanner, ColoursAreThoseAskedFor) {
  ScannerOptions options = faultless();
  options.colours.noise = 0;
  options.colours.garments = {{{10, 20, 200}, 0.05, {200, 20, 10}}};
  const ScannedPerson scan = scanned(dressed(), options);
  std::size_t hair = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    const Vec3& p = scan.cloud.positions[i];
    const Colour colour = scan.cloud.colours[i];
    if (scan.labels[i] == 0) {
      ASSERT_TRUE(colour == options.colours.skin || colour == options.colours.hair);
      hair += colour == options.colours.hair;
      if (p.y() < 0.85 * kHeight) {
        ASSERT_EQ(colour, options.colours.skin);
      }
      continue;
    }
    // Stripes of 5 cm from the waist down; nothing is said within 1 mm of where they meet.
    const double stripe = (kSkirt.top - p.y()) / 0.05;
    if (std::abs(stripe - std::round(stripe)) < 0.02) continue;
    ASSERT_EQ(colour, static_cast<int>(stripe) % 2 == 0 ? options.colours.garments[0].colour
                                                        : options.colours.garments[0].second);
  }
  EXPECT_GT(hair, 100U);
  options.colours.alike = 1;
  const ScannedPerson alike = scanned(dressed(), options);
  for (std::size_t i = 0; i < alike.labels.size(); ++i)
    if (alike.labels[i] == 1) {
      ASSERT_EQ(alike.cloud.colours[i], options.colours.skin);
    }
  options.colours.coloured = false;
  EXPECT_TRUE(scanned(dressed(), options).cloud.colours.empty());
}

TEST(Scanner, ThinningLeavesOnePointInEachCube) {
  ScannedPerson scan = scanned(dressed(), faultless());
  const ScannedPerson before = scan;
  const double spacing = 0.02;
  const auto cube_of = [&](const Vec3& p) {
    std::array<long, 3> cube;
    for (int i = 0; i < 3; ++i)
      cube[static_cast<std::size_t>(i)] = std::lround(std::floor(p[i] / spacing));
    return cube;
  };
  std::map<std::array<long, 3>, double> best;
  const auto off = [&](const Vec3& p) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = p[i] / spacing - std::floor(p[i] / spacing) - 0.5;
      sum += d * d;
    }
    return sum;
  };
  for (const Vec3& p : before.cloud.positions) {
    const auto [found, made] = best.try_emplace(cube_of(p), off(p));
    found->second = std::min(found->second, off(p));
  }
  thin_points(scan, spacing);
  ASSERT_EQ(scan.labels.size(), best.size());
  for (const Vec3& p : scan.cloud.positions) {
    EXPECT_NEAR(off(p), best.at(cube_of(p)), 1e-9);
  }
}

TEST(Scanner, ShufflingKeepsPointsAndTheirTruthTogether) {
  ScannedPerson scan = scanned(dressed(), faultless());
  const ScannedPerson before = scan;
  Random random(3);
  shuffle_points(scan, random);
  EXPECT_FALSE(same(scan, before));
  const auto rows = [](const ScannedPerson& of) {
    std::vector<std::tuple<double, double, double, int, std::uint32_t>> all;
    for (std::size_t i = 0; i < of.labels.size(); ++i) {
      const Vec3& p = of.cloud.positions[i];
      all.emplace_back(p.x(), p.y(), p.z(), of.labels[i], of.particle[i]);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(rows(scan), rows(before));
}

TEST(Scanner, RefusesWhatCannotBeScanned) {
  Random random(1);
  EXPECT_THROW(scan_person({}, {}, random), InvalidInput);
  DressedPerson giant;
  giant.body = test::column(1.9, 1.6, 0.2);
  EXPECT_THROW(scan_person(giant, {}, random), InvalidInput);
  ScannerOptions options;
  options.rig.missing = {0, 1, 2, 3};
  EXPECT_THROW(options.check(), InvalidInput);
  options = {};
  options.props.posts = 9;
  EXPECT_THROW(options.check(), InvalidInput);
  options = {};
  options.rig.columns = 1;
  EXPECT_THROW(options.check(), InvalidInput);
  options = {};
  options.colours.alike = 2;
  EXPECT_THROW(options.check(), InvalidInput);
  ScannedPerson scan;
  EXPECT_THROW(thin_points(scan, 0), InvalidInput);
  EXPECT_THROW(keep_points(scan, std::vector<std::uint32_t>{0}), InvalidInput);
}

}  // namespace
}  // namespace regarment
