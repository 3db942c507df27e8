#include "synthetic/body_growth.h"

#include <cmath>

namespace regarment {
namespace {

// Where the girth grows: a bump over the height, stronger in front, at the back or beside.
struct Bump {
  double amount;
  double height, spread;     // m
  double side, front, back;  // how the amount is shared out; about 1 on average
};

std::array<Bump, 4> bumps(const BodyShape& shape, const BodyJoints& frame) {
  const double leg = frame.crotch;
  return {Bump{shape.belly, frame.belly, 0.085, 0.9, 1.5, 0.4},
          Bump{shape.chest, frame.chest, 0.10, 0.9, 1.2, 0.8},
          Bump{shape.hips, 0.5 * (frame.hip + leg), 0.09, 1.0, 0.7, 1.3},
          Bump{shape.thighs, 0.86 * leg, 0.10, 1.0, 1.0, 1.0}};
}

// Where the trunk's axis stands, as seen from the side, m.
constexpr double kAxis = 0.03;
constexpr double kSoft = 0.05;  // m over which front turns into back and left into right

// How far a point of the trunk moves.
Vec3 trunk_move(const BodyShape& shape, const std::array<Bump, 4>& all, const Vec3& p) {
  const double forward = 0.5 + 0.5 * std::tanh((p.z() - kAxis) / kSoft);
  const double sided = 1 + shape.asymmetry * std::tanh(p.x() / kSoft);
  double across = 0, deep = 0;
  for (const Bump& bump : all) {
    const double u = (p.y() - bump.height) / bump.spread;
    const double here = bump.amount * sided * std::exp(-0.5 * u * u);
    across += here * bump.side;
    deep += here * (bump.front * forward + bump.back * (1 - forward));
  }
  return {p.x() * across, 0, (p.z() - kAxis) * deep};
}

// How far a shoulder moves out, fading towards the neck, the waist and the arm's own side.
double shoulder_move(const BodyShape& shape, const BodyJoints& frame, const Vec3& p) {
  const double reach = std::abs(frame.shoulder[0].x());
  const double out = smooth_step(0.3 * reach, reach, std::abs(p.x()));
  const double up = smooth_step(frame.belly, frame.chest, p.y());
  return std::copysign(shape.shoulders * out * up, p.x());
}

// An arm goes along with the trunk beside it and grows round its own line.
Vec3 arm_move(const BodyShape& shape, const std::array<Bump, 4>& all, const BodyJoints& frame,
              std::size_t side, const Vec3& p) {
  const Vec3& joint = frame.shoulder[side];
  const Vec3& along = frame.arm_along[side];
  const double s = (p - joint).dot(along);
  const Vec3 radial = p - joint - s * along;
  const double thick = shape.arms * smooth_step(0.02, 0.12, s) * (1 - smooth_step(0.3, 0.48, s));
  const Vec3 armpit(0.92 * joint.x(), joint.y() - 0.08, joint.z());
  Vec3 carried = trunk_move(shape, all, armpit);
  carried.z() = 0;
  carried.x() += std::copysign(shape.shoulders, joint.x());
  return carried + thick * radial;
}

}  // namespace

void grow_body(const BodyShape& shape, const BodyRig& rig, const BodyJoints& frame,
               std::vector<Vec3>& positions) {
  const std::array<Bump, 4> all = bumps(shape, frame);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 p = positions[v];
    const double trunk = 1 - rig.arm[0][v] - rig.arm[1][v];
    Vec3 move = trunk * trunk_move(shape, all, p);
    move.x() += trunk * shoulder_move(shape, frame, p);
    for (std::size_t side = 0; side < 2; ++side) {
      if (rig.arm[side][v] > 0) move += rig.arm[side][v] * arm_move(shape, all, frame, side, p);
    }
    positions[v] += move;
  }
}

}  // namespace regarment
