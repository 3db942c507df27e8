#include "synthetic/file_frame.h"

#include "scan/file_axis.h"
#include "scan/find_units.h"
#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

constexpr double kFurthest = 1000;      // m
constexpr double kNearlyAlong = 0.643;  // cosine of 50 degrees

// Columns: the body's left, up and ahead in the file.
Eigen::Matrix3d axes_of(const Vec3& up) {
  const Vec3 ahead(up.z(), up.x(), up.y());  // the next axis
  Eigen::Matrix3d axes;
  axes << up.cross(ahead), up, ahead;
  return axes;
}

}  // namespace

void FileFrame::check() const {
  metres_of(units);
  axis_vector(up);
  check_scanner_value("yaw", yaw, -100, 100);
  for (const double s : shift) check_scanner_value("shift", s, -kFurthest, kFurthest);
}

Eigen::Affine3d file_from_body(const FileFrame& frame) {
  frame.check();
  const Eigen::AngleAxisd turn(frame.yaw, Vec3::UnitY());
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.scale(1 / metres_of(frame.units));
  map.translate(frame.shift);
  map.rotate(axes_of(axis_vector(frame.up)) * turn.toRotationMatrix());
  return map;
}

std::vector<std::string> front_axes(const FileFrame& frame) {
  const Vec3 front = (file_from_body(frame).linear() * Vec3::UnitZ()).normalized();
  std::vector<std::string> out;
  for (const std::string_view name : kFileAxes)
    if (axis_vector(name).dot(front) > kNearlyAlong) out.emplace_back(name);
  return out;
}

void into_file_frame(const Eigen::Affine3d& file_from_body, Mesh& mesh) {
  for (Vec3& p : mesh.positions) p = file_from_body * p;
  for (Vec3& n : mesh.normals) {
    const Vec3 turned = file_from_body.linear() * n;
    n = turned.norm() > 0 ? Vec3(turned.normalized()) : Vec3::Zero();
  }
}

}  // namespace regarment
