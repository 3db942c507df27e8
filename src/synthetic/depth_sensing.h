#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "synthetic/depth_camera.h"
#include "synthetic/scanner_rig.h"
#include "synthetic/scanner_scene.h"

namespace regarment {

/// What goes wrong when a depth is measured. Angles are between the surface's normal and the ray.
struct SensingOptions {
  // m, 0 .. 0.003: standard deviation of the error along the ray at `noise_distance`, head on. It
  // grows with the square of the distance and with one over the cosine of the angle (to 1 / 0.2).
  double noise = 0.0005;
  // m, 0 .. 0.002: standard deviation of an error along the ray that neighbours share, as waves of
  // 5 to 20 pixels; averaging does not take it away as it does noise.
  double ripple = 0.0;
  double noise_distance = 2.0;  // m, 0.5 .. 5
  double quantum = 0.0;         // m, 0 .. 0.005: depths are multiples of it; 0: any
  // m, 0 .. 0.001: standard deviation, in each direction, of how far a camera believes to stand
  // from where it stands, and of how far its false turn moves what it sees at `noise_distance`.
  double calibration = 0.0002;
  double grazing_begin = 1.22, grazing_end = 1.45;  // rad, 0 .. pi/2: from none lost to all lost
  double dropout = 0.01;                            // 0 .. 0.9, share lost at random
  // 0 .. 1, share of the pixels at a jump in depth of 8 to 150 mm that see both sides of it: their
  // depth is anywhere between.
  double mixed = 0.2;
  // Per owner, the person first, then the garments: 0 .. 1, how little light comes back. Loses that
  // share of the points, more where light grazes, and trebles the noise at 1. Missing ones: 0.
  std::vector<double> darkness;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// A measured point.
struct SensedPoint {
  Vec3 position;               // body frame, m, as measured
  Vec3 normal;                 // unit, towards the camera, from the measured points around
  Vec3 true_position;          // on the surface
  std::uint32_t triangle = 0;  // of the scene
  // Lies between two surfaces, more than 4 mm from either along the ray.
  bool flying = false;
};

/// What one sensor measures of a scene, in the order of its pixels. A point must be seen from the
/// camera and lie in its projector's light.
std::vector<SensedPoint> sense(const ScannerScene& scene, const DepthSensor& sensor,
                               const SensingOptions& options, Random& random);

}  // namespace regarment
