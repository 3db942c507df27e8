#include "synthetic/body_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.h"
#include "geometry/closest_point.h"
#include "synthetic/body_growth.h"
#include "synthetic/body_library.h"
#include "synthetic/body_pose.h"
#include "synthetic/body_rig.h"

namespace regarment {
namespace {

constexpr double kMostArmAngle = 1.1;
constexpr double kArmStep = 0.02;

void check_range(const char* name, double value, double low, double high) {
  if (std::isfinite(value) && value >= low && value <= high) return;
  throw InvalidInput("body shape: " + std::string(name) + " is " + std::to_string(value) +
                     ", it must be " + std::to_string(low) + " to " + std::to_string(high));
}

std::vector<Vec3> blend(const BodyLibrary& library, const BodyShape& shape) {
  std::vector<Vec3> out(library.positions.front().size(), Vec3::Zero());
  for (std::size_t body = 0; body < shape.blend.size(); ++body) {
    if (shape.blend[body] == 0) continue;
    for (std::size_t v = 0; v < out.size(); ++v) {
      out[v] += shape.blend[body] * library.positions[body][v];
    }
  }
  return out;
}

void stand_on_floor(double scale, std::vector<Vec3>& positions) {
  double floor = positions.front().y();
  for (const Vec3& p : positions) floor = std::min(floor, p.y());
  for (Vec3& p : positions) p = scale * (p - Vec3(0, floor, 0));
}

// Triangles that do not belong to the arm of one side, nor to either arm's upper part.
std::vector<std::uint8_t> mask_arms(const BodyRig& rig, const std::vector<Triangle>& triangles) {
  std::vector<std::uint8_t> masked(triangles.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const auto v : triangles[t]) {
      if (rig.arm[0][v] > 0.02 || rig.arm[1][v] > 0.02) masked[t] = 1;
    }
  }
  return masked;
}

std::array<double, 2> clearances(const Mesh& body) {
  const BodyRig& rig = body_rig();
  const BodyJoints frame = body_joints(rig, body.positions);
  const std::vector<std::uint8_t> masked = mask_arms(rig, body.triangles);
  const ClosestPoint trunk(body.positions, body.triangles, masked);
  constexpr double kUpperArm = 0.25;  // m from the joint; above it arm and trunk are neighbours
  std::array<double, 2> out = {1, 1};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t v = 0; v < body.positions.size(); ++v) {
      if (rig.arm[side][v] < 1) continue;
      const Vec3& p = body.positions[v];
      if ((p - frame.shoulder[side]).dot(frame.arm_along[side]) < kUpperArm) continue;
      const ClosestHit hit = trunk.closest(p, {.max_distance = out[side]});
      if (hit.found()) out[side] = std::sqrt(hit.squared_distance);
    }
  }
  return out;
}

}  // namespace

void BodyShape::check() const {
  for (const double share : blend) check_range("blend", share, 0, 1);
  check_range("sum of blend", std::accumulate(blend.begin(), blend.end(), 0.0), 1 - 1e-9, 1 + 1e-9);
  check_range("scale", scale, 0.85, 1.15);
  check_range("belly", belly, -0.1, 0.2);
  check_range("chest", chest, -0.1, 0.2);
  check_range("hips", hips, -0.1, 0.2);
  check_range("thighs", thighs, -0.1, 0.2);
  check_range("arms", arms, -0.1, 0.2);
  check_range("shoulders", shoulders, -0.02, 0.03);
  check_range("asymmetry", asymmetry, -0.4, 0.4);
  for (const double angle : arm_angle) check_range("arm_angle", angle, 0.1, kMostArmAngle);
  check_range("arms_back", arms_back, -0.1, 0.5);
  check_range("legs", legs, -0.1, 0.06);
  check_range("twist", twist, -0.2, 0.2);
  check_range("lean", lean, -0.08, 0.08);
  check_range("stoop", stoop, -0.08, 0.12);
  check_range("tilt", tilt, -0.06, 0.06);
  check_range("sway", sway, -0.03, 0.03);
}

Mesh make_body(const BodyShape& shape) {
  shape.check();
  const BodyLibrary& library = body_library();
  const BodyRig& rig = body_rig();
  Mesh out;
  out.positions = blend(library, shape);
  const BodyJoints frame = body_joints(rig, out.positions);
  grow_body(shape, rig, frame, out.positions);
  pose_body(shape, rig, frame, out.positions);
  stand_on_floor(shape.scale, out.positions);
  out.triangles = library.triangles;
  return out;
}

double arm_clearance(const Mesh& body) {
  const std::array<double, 2> both = clearances(body);
  return std::min(both[0], both[1]);
}

BodyShape with_free_arms(BodyShape shape, double clearance) {
  while (true) {
    const std::array<double, 2> free = clearances(make_body(shape));
    bool moved = false;
    for (std::size_t side = 0; side < 2; ++side) {
      double& angle = shape.arm_angle[side];
      if (free[side] >= clearance || angle >= kMostArmAngle) continue;
      angle = std::min(angle + kArmStep, kMostArmAngle);
      moved = true;
    }
    if (!moved) return shape;
  }
}

}  // namespace regarment
