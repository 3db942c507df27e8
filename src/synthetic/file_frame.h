#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// The frame a scan file happens to be in: a scanner says neither unit nor axes. Never mirrored.
struct FileFrame {
  std::string units = "m";    // "mm", "cm", "m" or "inch"
  std::string up = "+y";      // the file's axis that points up: "+x" ... "-z"
  double yaw = 0.0;           // rad, how far the person is turned to its left about the upright
  Vec3 shift = Vec3::Zero();  // m, -1000 .. 1000 per axis (a file's floats then hold 0.1 mm):
                              // where the body frame's origin lies, along the file's axes

  /// Throws InvalidInput naming the field and its value, UsageError for an unknown unit or axis.
  void check() const;
};

/// Brings points of the body frame (m) to the file: a turn, a shift, a uniform scale. With yaw 0
/// the body's axes lie along the file's.
Eigen::Affine3d file_from_body(const FileFrame& frame);

/// The file's axes that lie within 50 degrees of where the person faces, as "+x" ... "-z": one, or
/// two where it is hard to say.
std::vector<std::string> front_axes(const FileFrame& frame);

/// Moves positions and normals, which stay unit.
void into_file_frame(const Eigen::Affine3d& file_from_body, Mesh& mesh);

}  // namespace regarment
