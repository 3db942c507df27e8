#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "synthetic/depth_camera.h"

namespace regarment {

/// Where the scanner's cameras stand: in columns around the person.
struct RigOptions {
  int columns = 4;             // 2 .. 8, evenly around
  int cameras_per_column = 3;  // 2 .. 4, evenly from knee height to above the head
  double distance = 2.0;       // m, 1.5 .. 4, from the column to the middle line
  double yaw = 0.7854;         // rad, of the first column: 0 straight ahead, then to the left
  std::vector<int> missing;    // columns that do not work, 0 .. columns - 1; not all of them
  // m, 0.2 .. 0.4, from a camera up to its projector: what either does not see is not measured.
  double baseline = 0.3;
  double pixel = 0.003;  // m, 0.001 .. 0.02, side of a pixel at the middle line

  void check() const;  // throws InvalidInput naming the field and its value
};

/// A camera and its projector, which sees as a camera does.
struct DepthSensor {
  DepthCamera camera, projector;
  // Counts those of missing columns too, so that the others' dice do not change with them.
  std::uint32_t number = 0;
};

/// The sensors, column by column, each from below. `points` is everything there is to see, body
/// frame, within 1.2 m of the middle line x = z = 0; `height` that of the person. Throws
/// InvalidInput for options out of range or points that come too near a camera.
std::vector<DepthSensor> make_rig(const RigOptions& options, double height,
                                  std::span<const Vec3> points);

}  // namespace regarment
