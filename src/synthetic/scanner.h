#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/random.h"
#include "synthetic/depth_sensing.h"
#include "synthetic/dressed_person.h"
#include "synthetic/scanner_colours.h"
#include "synthetic/scanner_props.h"
#include "synthetic/scanner_rig.h"

namespace regarment {

/// A body scanner and its faults.
struct ScannerOptions {
  RigOptions rig;
  SensingOptions sensing;
  ColourOptions colours;
  PropOptions props;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// What a scanner made of a dressed person, and the truth of each point. All vectors have one entry
/// per point.
struct ScannedPerson {
  static constexpr std::uint8_t kOutlier = 255;
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// Points in the body frame, m. Normals are estimated from the depth pictures, unit, towards the
  /// scanner: what surfaces are made with, not what a cloud's file holds. Colours when asked for.
  Mesh cloud;
  std::vector<std::uint8_t> labels;  // 0 person, i = i-th garment, 255 outlier or prop
  /// Particle of the garment's pattern nearest to the point where it was measured; kNone off the
  /// garments and on the inner side of the cloth.
  std::vector<std::uint32_t> particle;
};

/// Scans a person: all cameras' points merged, in the order of cameras and pixels. Sensors work on
/// all threads; the same input and state of `random` give the same bytes whatever their number.
/// About half a second on one core for 12 cameras and 200,000 points. Throws InvalidInput for
/// options out of range, a person without triangles or one that comes near a camera.
ScannedPerson scan_person(const DressedPerson& person, const ScannerOptions& options,
                          Random& random);

/// Keeps the points of these indices, in this order.
void keep_points(ScannedPerson& scan, std::span<const std::uint32_t> kept);

/// One point in each cube of `spacing` metres (0.0005 to 0.05, body frame): the one nearest to its
/// middle. Cubes in rising order of z, then y, then x.
void thin_points(ScannedPerson& scan, double spacing);

/// Points in random order, so that neighbours in the file are none on the body.
void shuffle_points(ScannedPerson& scan, Random& random);

/// Which particles of garment `label` (1 = outermost) have a point: one entry per particle, 1 or 0.
/// Ask before thinning.
std::vector<std::uint8_t> seen_particles(const ScannedPerson& scan, std::uint8_t label,
                                         std::size_t particles);

}  // namespace regarment
