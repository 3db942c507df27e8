#include "synthetic/body_pose.h"

#include <Eigen/Geometry>
#include <cmath>

namespace regarment {
namespace {

Vec3 turned(const Vec3& p, const Vec3& centre, double angle, const Vec3& axis) {
  return centre + Eigen::AngleAxisd(angle, axis) * (p - centre);
}

// Angle by which the arm has to turn about the axis that points to the front.
double arm_turn(const BodyShape& shape, const BodyJoints& frame, std::size_t side) {
  const Vec3& along = frame.arm_along[side];
  const double now = std::atan2(std::abs(along.x()), -along.y());
  const double out = shape.arm_angle[side] - now;
  return side == 0 ? out : -out;
}

// The legs turn about the hips, the feet back again, so that they stay on the floor.
Vec3 pose_leg(const BodyShape& shape, const BodyJoints& frame, const Vec3& p) {
  const double sign = p.x() > 0 ? 1.0 : -1.0;
  const double leg = 1 - smooth_step(0.62 * frame.crotch, 0.99 * frame.crotch, p.y());
  if (leg == 0) return p;
  const Vec3 hip(sign * 0.09, frame.crotch, 0.03), ankle(sign * 0.18, 0.09, 0.02);
  const double angle = sign * shape.legs;
  const double foot = 1 - smooth_step(0.05, 0.16, p.y());
  const Vec3 level = turned(p, ankle, -foot * angle, Vec3::UnitZ());
  return turned(level, hip, leg * angle, Vec3::UnitZ());
}

// `level`: the height at which the spine carries this vertex.
Vec3 pose_spine(const BodyShape& shape, const BodyJoints& frame, double level, const Vec3& p) {
  const double bent = smooth_step(frame.hip, frame.chest + 0.1, level);
  const double tilted = smooth_step(frame.belly, frame.chest + 0.1, level) *
                        (1 - 0.8 * smooth_step(frame.neck - 0.02, frame.neck + 0.08, level));
  const Vec3 hip(0, frame.hip, 0.02), chest(0, frame.chest, 0.02);
  Vec3 q = turned(p, hip, bent * shape.twist, Vec3::UnitY());
  q = turned(q, hip, bent * shape.stoop, Vec3::UnitX());
  q = turned(q, hip, -bent * shape.lean, Vec3::UnitZ());
  q = turned(q, chest, -tilted * shape.tilt, Vec3::UnitZ());
  // The upper body comes half-way back over the feet.
  const double shift = smooth_step(0.1, frame.hip, level) * (1 - 0.5 * bent);
  return q + Vec3(shape.sway * shift, 0, 0);
}

}  // namespace

void pose_body(const BodyShape& shape, const BodyRig& rig, const BodyJoints& frame,
               std::vector<Vec3>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    Vec3 p = positions[v];
    double level = p.y();
    for (std::size_t side = 0; side < 2; ++side) {
      const double w = rig.arm[side][v];
      if (w == 0) continue;
      level += w * (frame.shoulder[side].y() - level);
      Vec3 joint = frame.shoulder[side];
      joint.x() += std::copysign(shape.shoulders, joint.x());
      p = turned(p, joint, w * shape.arms_back, Vec3::UnitX());
      p = turned(p, joint, w * arm_turn(shape, frame, side), Vec3::UnitZ());
    }
    if (level < frame.crotch) p = pose_leg(shape, frame, p);
    positions[v] = pose_spine(shape, frame, level, p);
  }
}

}  // namespace regarment
