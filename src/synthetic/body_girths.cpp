#include "synthetic/body_girths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "synthetic/body_rig.h"
#include "synthetic/slice_loops.h"

namespace regarment {
namespace {

constexpr double kStep = 0.01;  // m between the heights that are tried

double middle_x(const std::vector<Loop>& loops) {
  double sum = 0, area = 0;
  for (const Loop& loop : loops) {
    sum += loop.area * loop.centre.x();
    area += loop.area;
  }
  return area > 0 ? sum / area : 0;
}

bool encloses(const Loop& loop, double x) { return loop.low.x() < x && loop.high.x() > x; }

// The trunk's own outlines among all of a slice.
std::vector<const Loop*> trunk_loops(const std::vector<Loop>& loops) {
  const double middle = middle_x(loops);
  std::vector<const Loop*> out;
  const Loop* left = nullptr;
  const Loop* right = nullptr;
  for (const Loop& loop : loops) {
    if (encloses(loop, middle)) {
      out.push_back(&loop);
    } else if (loop.centre.x() > middle) {
      if (left == nullptr || loop.centre.x() < left->centre.x()) left = &loop;
    } else if (right == nullptr || loop.centre.x() > right->centre.x()) {
      right = &loop;
    }
  }
  if (!out.empty()) return out;
  if (left != nullptr) out.push_back(left);
  if (right != nullptr) out.push_back(right);
  return out;
}

double girth_of(const std::vector<const Loop*>& loops) {
  std::vector<Vec2> points;
  for (const Loop* loop : loops) {
    points.insert(points.end(), loop->points.begin(), loop->points.end());
  }
  return hull_perimeter(std::move(points));
}

struct Extreme {
  double height = 0, girth = 0;
};

// The widest (sign 1) or narrowest (sign -1) girth between two heights, or distances along a limb.
template <typename Girth>
Extreme search(double from, double to, double sign, const Girth& girth_at) {
  Extreme best{from, 0};
  double best_score = -std::numeric_limits<double>::infinity();
  for (double y = from; y <= to; y += kStep) {
    const double girth = girth_at(y);
    if (girth == 0 || sign * girth <= best_score) continue;
    best_score = sign * girth;
    best = {y, girth};
  }
  return best;
}

// The girth where no arm has joined the trunk yet, else 0.
double chest_girth(const Mesh& body, double height, double half_width) {
  const std::vector<Loop> loops = slice_loops(body, height);
  const std::vector<const Loop*> trunk = trunk_loops(loops);
  for (const Loop* loop : trunk) {
    if (loop->high.x() - loop->low.x() > 2 * half_width) return 0;
  }
  return girth_of(trunk);
}

// Top of the shoulders where a neckline ends; the head is higher and not looked at.
double neck_height(const Mesh& body, const BodyJoints& frame, double unit) {
  double out = frame.chest;
  for (const Vec3& p : body.positions) {
    const bool beside = std::abs(std::abs(p.x()) - 0.1) < 0.012;
    if (beside && p.y() < frame.neck + 0.04 * unit) out = std::max(out, p.y());
  }
  return out;
}

// The left arm alone, turned so that its own line points up and the joint lies at the origin.
Mesh upright_arm(const Mesh& body, const BodyJoints& frame) {
  const BodyRig& rig = body_rig();
  const Vec3 line = frame.arm_along[0];
  const auto turn = Eigen::Quaterniond::FromTwoVectors(line, Vec3::UnitY());
  Mesh arm;
  arm.positions.reserve(body.positions.size());
  for (const Vec3& p : body.positions) arm.positions.push_back(turn * (p - frame.shoulder[0]));
  for (const Triangle& t : body.triangles) {
    if (rig.arm[0][t[0]] > 0.5 && rig.arm[0][t[1]] > 0.5 && rig.arm[0][t[2]] > 0.5) {
      arm.triangles.push_back(t);
    }
  }
  return arm;
}

}  // namespace

double tape_girth(const Mesh& body, double height) {
  const std::vector<Loop> loops = slice_loops(body, height);
  return girth_of(trunk_loops(loops));
}

BodyGirths body_girths(const Mesh& body) {
  const BodyJoints frame = body_joints(body_rig(), body.positions);
  BodyGirths out;
  for (const Vec3& p : body.positions) out.height = std::max(out.height, p.y());
  const double unit = out.height / 1.67;  // of the body the rig was made from
  out.crotch = frame.crotch;
  out.neck_height = neck_height(body, frame, unit);
  out.shoulder = 0.5 * (frame.shoulder[0] - frame.shoulder[1]).norm();
  const auto trunk = [&](double y) { return tape_girth(body, y); };
  const auto chest = [&](double y) { return chest_girth(body, y, 1.05 * out.shoulder); };
  const Mesh arm = upright_arm(body, frame);
  const auto round_arm = [&](double along) { return tape_girth(arm, along); };
  const Extreme hip = search(frame.crotch + 0.01, frame.belly, 1, trunk);
  const Extreme waist = search(hip.height + 0.08, frame.chest - 0.02 * unit, -1, trunk);
  const Extreme widest = search(frame.chest - 0.06 * unit, frame.chest + 0.03 * unit, 1, chest);
  const Extreme wrist = search(0.38 * unit, 0.5 * unit, -1, round_arm);
  out.hip_height = hip.height, out.hip = hip.girth;
  out.waist_height = waist.height, out.waist = waist.girth;
  out.chest_height = widest.height, out.chest = widest.girth;
  out.arm = wrist.height, out.wrist_girth = wrist.girth;
  out.upper_arm_girth = round_arm(0.15 * unit);
  return out;
}

}  // namespace regarment
