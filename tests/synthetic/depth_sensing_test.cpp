#include "synthetic/depth_sensing.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kPixel = 0.003;

/// A square wall through (0, 1, z), turned about the upright by `turn` from facing +z.
Mesh wall(double z, double half, double turn = 0) {
  const Vec3 side = half * Vec3(std::cos(turn), 0, -std::sin(turn)), up(0, half, 0);
  const Vec3 middle(0, 1, z);
  Mesh mesh;
  mesh.positions = {middle - side - up, middle + side - up, middle + side + up, middle - side + up};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

ScannerScene scene_of(const std::vector<Mesh>& meshes) {
  ScannerScene scene;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    scene.add(meshes[i], static_cast<std::uint8_t>(i));
  return scene;
}

/// Two metres before the wall at z = 0, level; the projector 0.3 m above.
DepthSensor sensor_for(const ScannerScene& scene) {
  DepthSensor sensor;
  const Vec3 target(0, 1, 0);
  sensor.camera = aim_camera({0, 1, 2}, target, 0.6, kPixel, scene.positions);
  sensor.projector = aim_camera({0, 1.3, 2}, target, 0.9, kPixel, scene.positions);
  return sensor;
}

SensingOptions faultless() {
  SensingOptions options;
  options.noise = options.calibration = options.dropout = options.mixed = 0;
  options.grazing_begin = options.grazing_end = std::numbers::pi / 2;
  return options;
}

std::vector<SensedPoint> sensed(const ScannerScene& scene, const SensingOptions& options,
                                std::uint64_t seed = 1) {
  Random random(seed);
  return sense(scene, sensor_for(scene), options, random);
}

double deviation(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += v, squares += v * v;
  const double n = static_cast<double>(values.size()), mean = sum / n;
  return std::sqrt(squares / n - mean * mean);
}

TEST(DepthSensing, WithoutFaultsPointsLieOnTheSurface) {
  const ScannerScene scene = scene_of({wall(0, 0.4, 0.3)});
  const std::vector<SensedPoint> points = sensed(scene, faultless());
  EXPECT_GT(points.size(), 50000U);
  const Vec3 normal(std::sin(0.3), 0, std::cos(0.3));
  for (const SensedPoint& p : points) {
    ASSERT_NEAR(normal.dot(p.position), 0, 1e-9);
    ASSERT_LT((p.position - p.true_position).norm(), 1e-12);
    ASSERT_FALSE(p.flying);
    ASSERT_GT(normal.dot(p.normal), 1 - 1e-9);
  }
}

TEST(DepthSensing, NoiseHasTheSigmaAskedFor) {
  SensingOptions options = faultless();
  options.noise = 0.0008;
  const ScannerScene scene = scene_of({wall(0, 0.4)});
  std::vector<double> error;
  for (const SensedPoint& p : sensed(scene, options))
    if ((p.true_position - Vec3(0, 1, 0)).norm() < 0.2)
      error.push_back((p.position - p.true_position).z());
  ASSERT_GT(error.size(), 10000U);
  // Three standard errors of a deviation from 10,000 values, and half a per cent for the angles.
  EXPECT_NEAR(deviation(error), options.noise, 0.026 * options.noise);
}

TEST(DepthSensing, RippleHasItsSigmaAndIsSharedByNeighbours) {
  SensingOptions options = faultless();
  options.ripple = 0.001;
  const ScannerScene scene = scene_of({wall(0, 0.4)});
  std::vector<double> error, step;
  const std::vector<SensedPoint> points = sensed(scene, options);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto off = [&](std::size_t k) {
      return (points[k].position - points[k].true_position).z();
    };
    error.push_back(off(i));
    if ((points[i].true_position - points[i - 1].true_position).norm() < 1.1 * kPixel)
      step.push_back(off(i) - off(i - 1));
  }
  // Hundreds of waves' lengths go over the wall, so that each wave's mean square is half.
  EXPECT_NEAR(deviation(error), options.ripple, 0.05 * options.ripple);
  // A wave of five pixels changes by at most 2 sin(pi / 5) = 1.18 of its size from one to the next.
  EXPECT_LT(deviation(step), 1.18 * options.ripple);
  EXPECT_GT(deviation(step), 0.05 * options.ripple);
}

TEST(DepthSensing, NoiseGrowsWithDistanceAndAngle) {
  SensingOptions options = faultless();
  options.noise = 0.0005;
  const double turn = std::numbers::pi / 3;
  const auto noise_of = [&](const Mesh& mesh) {
    std::vector<double> error;
    const ScannerScene scene = scene_of({mesh});
    for (const SensedPoint& p : sensed(scene, options))
      if (std::abs(p.true_position.x()) < 0.1 && std::abs(p.true_position.y() - 1) < 0.2)
        error.push_back((p.position - Vec3(0, 1, 2)).norm() -
                        (p.true_position - Vec3(0, 1, 2)).norm());
    return deviation(error);
  };
  // (3 / 2)^2 = 2.25 at three metres, 1 / cos 60 = 2 at sixty degrees; 5 % for the spread of
  // angles and distances over the patch and for chance.
  EXPECT_NEAR(noise_of(wall(-1, 0.4)), 2.25 * options.noise, 0.05 * 2.25 * options.noise);
  EXPECT_NEAR(noise_of(wall(0, 0.4, turn)), 2 * options.noise, 0.05 * 2 * options.noise);
}

TEST(DepthSensing, NothingIsSeenBehindAnObstacleNorInItsShadow) {
  // A plate half a metre before the wall hides from camera and light each a square of its own.
  const double plate = 0.1, at = 0.5;
  const ScannerScene scene = scene_of({wall(0, 0.5), wall(at, plate)});
  const auto hides = [&](const Vec3& eye, const Vec3& p, double margin) {
    const Vec3 q = p + (eye - p) * (at - p.z()) / (eye.z() - p.z());
    return std::abs(q.x()) < plate - margin && std::abs(q.y() - 1) < plate - margin;
  };
  const double slack = 2 * kPixel;  // the light's picture has pixels too
  double expected = 0, seen = 0;
  const DepthSensor sensor = sensor_for(scene);
  for (const SensedPoint& p : sensed(scene, faultless())) {
    if (p.true_position.z() > 0.1) continue;
    EXPECT_FALSE(hides(sensor.camera.eye, p.true_position, 1e-6));
    EXPECT_FALSE(hides(sensor.projector.eye, p.true_position, slack));
    ++seen;
  }
  for (double x = -0.5 + kPixel / 2; x < 0.5; x += kPixel)
    for (double y = 0.5 + kPixel / 2; y < 1.5; y += kPixel)
      expected +=
          !hides(sensor.camera.eye, {x, y, 0}, 0) && !hides(sensor.projector.eye, {x, y, 0}, 0);
  EXPECT_NEAR(seen, expected, 0.02 * expected);
}

TEST(DepthSensing, LosesTheShareAskedFor) {
  const ScannerScene scene = scene_of({wall(0, 0.2)});
  const auto all = static_cast<double>(sensed(scene, faultless()).size());
  const auto share = [&](const SensingOptions& options) {
    return static_cast<double>(sensed(scene, options).size()) / all;
  };
  const double chance = 4 * std::sqrt(0.25 / all);  // four standard errors
  SensingOptions options = faultless();
  options.dropout = 0.3;
  EXPECT_NEAR(share(options), 0.7, chance);
  options = faultless();
  options.darkness = {0.5};
  EXPECT_NEAR(share(options), 0.5, chance + 0.01);  // a little more away from the middle
  options.darkness = {0, 0.5};                      // a garment's, and there is none
  EXPECT_EQ(share(options), 1);
}

TEST(DepthSensing, GrazingRaysAreLost) {
  const double turn = 75 * std::numbers::pi / 180;
  const ScannerScene scene = scene_of({wall(0, 0.1, turn)});
  SensingOptions options = faultless();
  const auto all = static_cast<double>(sensed(scene, options).size());
  ASSERT_GT(all, 500);
  options.grazing_begin = 60 * std::numbers::pi / 180;
  options.grazing_end = 90 * std::numbers::pi / 180;
  // Half way between at the middle of the wall.
  EXPECT_NEAR(static_cast<double>(sensed(scene, options).size()) / all, 0.5, 0.1);
  options.grazing_end = 65 * std::numbers::pi / 180;
  EXPECT_EQ(sensed(scene, options).size(), 0U);
}

TEST(DepthSensing, MixedPixelsLieBetweenAndAreKnownToFly) {
  const double gap = 0.06;
  const ScannerScene scene = scene_of({wall(0, 0.3), wall(gap, 0.1)});
  SensingOptions options = faultless();
  options.mixed = 1;
  int flying = 0, plain = 0;
  for (const SensedPoint& p : sensed(scene, options)) {
    const double z = p.position.z();
    const double off = std::min(std::abs(z), std::abs(z - gap));
    // Along the ray is a little more than along z.
    if (p.flying) {
      EXPECT_GT(off, 0.0038);
      ++flying;
    } else {
      EXPECT_LT(off, 0.0042);
      // The surface it is counted to is the nearer one.
      EXPECT_EQ(scene.owner[p.triangle], z > gap / 2 ? 1 : 0);
      ++plain;
    }
  }
  EXPECT_GT(flying, 100);
  EXPECT_GT(plain, 10000);
}

TEST(DepthSensing, QuantumLeavesMultiples) {
  SensingOptions options = faultless();
  options.noise = 0.001;
  options.quantum = 0.002;
  const ScannerScene scene = scene_of({wall(0, 0.2)});
  for (const SensedPoint& p : sensed(scene, options)) {
    const double steps = (2 - p.position.z()) / options.quantum;
    ASSERT_NEAR(steps, std::round(steps), 1e-6);
  }
}

TEST(DepthSensing, CalibrationMovesAllPointsAsOneBody) {
  SensingOptions options = faultless();
  options.calibration = 0.0005;
  const ScannerScene scene = scene_of({wall(0, 0.3)});
  const std::vector<SensedPoint> points = sensed(scene, options);
  double furthest = 0;
  const SensedPoint &a = points.front(), &b = points.back();
  for (const SensedPoint& p : points) {
    furthest = std::max(furthest, (p.position - p.true_position).norm());
    for (const SensedPoint* other : {&a, &b})
      ASSERT_NEAR((p.position - other->position).norm(),
                  (p.true_position - other->true_position).norm(), 1e-9);
  }
  EXPECT_GT(furthest, 1e-5);
  EXPECT_LT(furthest, 0.005);  // ten deviations
}

TEST(DepthSensing, RefusesFaultsOutOfRange) {
  for (double SensingOptions::*field :
       {&SensingOptions::noise, &SensingOptions::ripple, &SensingOptions::noise_distance,
        &SensingOptions::quantum, &SensingOptions::calibration, &SensingOptions::grazing_begin,
        &SensingOptions::grazing_end, &SensingOptions::dropout, &SensingOptions::mixed})
    for (const double value : {-1.0, 10.0, std::nan("")}) {
      SensingOptions options;
      options.*field = value;
      EXPECT_THROW(options.check(), InvalidInput);
    }
  SensingOptions options;
  options.darkness = {0.5, 1.5};
  EXPECT_THROW(options.check(), InvalidInput);
}

}  // namespace
}  // namespace regarment
