#include "synthetic/scanner_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/error.h"
#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

constexpr double kLowest = 0.35;     // m, height of the lowest camera
constexpr double kAboveHead = 0.25;  // m, of the highest
constexpr double kOverlap = 0.15;    // m that pictures of a column share at the middle line

DepthSensor sensor_at(const RigOptions& options, int column, int level, double height,
                      std::span<const Vec3> points) {
  const double angle = options.yaw + 2 * std::numbers::pi * column / options.columns;
  const int levels = options.cameras_per_column;
  const double up = kLowest + (height + kAboveHead - kLowest) * level / (levels - 1);
  const Vec3 eye(options.distance * std::sin(angle), up, options.distance * std::cos(angle));
  const Vec3 target(0, height * (level + 0.5) / levels, 0);
  const double half_height = 0.5 * height / levels + kOverlap;
  DepthSensor sensor;
  sensor.camera = aim_camera(eye, target, half_height, options.pixel, points);
  // The projector stands nearer or farther as it looks up or down: its picture holds the camera's.
  sensor.projector = aim_camera(eye + Vec3(0, options.baseline, 0), target, 1.5 * half_height,
                                options.pixel, points);
  sensor.number = static_cast<std::uint32_t>(column * levels + level);
  return sensor;
}

}  // namespace

void RigOptions::check() const {
  check_scanner_value("columns", columns, 2, 8);
  check_scanner_value("cameras_per_column", cameras_per_column, 2, 4);
  check_scanner_value("distance", distance, 1.5, 4);
  check_scanner_value("yaw", yaw, -100, 100);
  check_scanner_value("baseline", baseline, 0.2, 0.4);
  check_scanner_value("pixel", pixel, 0.001, 0.02);
  for (const int column : missing) check_scanner_value("missing", column, 0, columns - 1);
  const std::set<int> gone(missing.begin(), missing.end());
  if (gone.size() == static_cast<std::size_t>(columns))
    throw InvalidInput("a scanner misses all its columns: leave one");
}

std::vector<DepthSensor> make_rig(const RigOptions& options, double height,
                                  std::span<const Vec3> points) {
  options.check();
  std::vector<DepthSensor> sensors;
  for (int column = 0; column < options.columns; ++column) {
    if (std::find(options.missing.begin(), options.missing.end(), column) != options.missing.end())
      continue;
    for (int level = 0; level < options.cameras_per_column; ++level)
      sensors.push_back(sensor_at(options, column, level, height, points));
  }
  return sensors;
}

}  // namespace regarment
