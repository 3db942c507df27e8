#include "synthetic/body_rig.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "synthetic/body_library.h"

namespace regarment {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

// The left arm of the first body, seen from the front: where it hangs and along which line, m.
const Vec2 kShoulder(0.165, 1.335);
const Vec2 kAlong(0.643, -0.766);
constexpr double kJointToRing = 0.11;  // m from the joint to the middle of the ring round the arm

struct ArmPlace {
  double along, across;  // m, from the joint; across > 0 is above the arm
};

ArmPlace arm_place(const Vec3& p, int side) {
  const Vec2 q = Vec2(side == 0 ? p.x() : -p.x(), p.y()) - kShoulder;
  return {q.dot(kAlong), q.x() * -kAlong.y() + q.y() * kAlong.x()};
}

bool is_arm(const ArmPlace& q) { return q.along > 0.17 && std::abs(q.across) < 0.11; }

bool is_round_shoulder(const ArmPlace& q, const Vec3& p) {
  return q.along > -0.06 && std::abs(q.across) < 0.17 && std::abs(p.x()) > 0.08;
}

std::vector<int> ring(const std::vector<Vec3>& positions, int side, double from, double to) {
  std::vector<int> out;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const ArmPlace q = arm_place(positions[v], side);
    if (q.along > from && q.along < to && std::abs(q.across) < 0.085) {
      out.push_back(static_cast<int>(v));
    }
  }
  return out;
}

// Numbers the vertices that are neither arm nor trunk; -1 for those that are.
std::vector<int> number_free(const std::vector<Vec3>& positions, int side,
                             std::vector<double>& known) {
  std::vector<int> number(positions.size(), -1);
  int count = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const ArmPlace q = arm_place(positions[v], side);
    const bool own_side = (side == 0) == (positions[v].x() > 0);
    if (own_side && is_arm(q)) {
      known[v] = 1;
    } else if (own_side && is_round_shoulder(q, positions[v])) {
      number[v] = count++;
    }
  }
  return number;
}

// Each free vertex becomes the mean of its neighbours: the smoothest way from arm to trunk.
void spread(const std::vector<Triangle>& triangles, const std::vector<int>& number,
            std::vector<double>& weight) {
  const int count = *std::max_element(number.begin(), number.end()) + 1;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  const auto pull = [&](std::uint32_t from, std::uint32_t to) {
    const int row = number[from];
    if (row < 0) return;
    entries.emplace_back(row, row, 1.0);
    if (number[to] >= 0) {
      entries.emplace_back(row, number[to], -1.0);
    } else {
      right[row] += weight[to];
    }
  };
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      pull(t[k], t[(k + 1) % 3]);
      pull(t[(k + 1) % 3], t[k]);
    }
  }
  Sparse matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd solved = Eigen::SimplicialLDLT<Sparse>(matrix).solve(right);
  for (std::size_t v = 0; v < weight.size(); ++v) {
    if (number[v] >= 0) weight[v] = solved[number[v]];
  }
}

std::vector<double> arm_weight(const BodyLibrary& library, int side) {
  const std::vector<Vec3>& positions = library.positions.front();
  std::vector<double> weight(positions.size(), 0.0);
  const std::vector<int> number = number_free(positions, side, weight);
  spread(library.triangles, number, weight);
  for (double& w : weight) w = smooth_step(0, 1, w);
  return weight;
}

// The vertex on the middle line of the front nearest to a height.
int on_front(const std::vector<Vec3>& positions, double height) {
  const auto far = [&](const Vec3& p) {
    return std::abs(p.y() - height) + 10 * std::abs(p.x()) + (p.z() < 0.03 ? 1.0 : 0.0);
  };
  const auto best = std::min_element(positions.begin(), positions.end(),
                                     [&](const Vec3& a, const Vec3& b) { return far(a) < far(b); });
  return static_cast<int>(best - positions.begin());
}

// The lowest vertex between the legs.
int find_crotch(const std::vector<Vec3>& positions) {
  const auto lies = [](const Vec3& p) { return p.y() + 100 * std::abs(p.x()); };
  const auto best =
      std::min_element(positions.begin(), positions.end(),
                       [&](const Vec3& a, const Vec3& b) { return lies(a) < lies(b); });
  return static_cast<int>(best - positions.begin());
}

BodyRig make_rig(const BodyLibrary& library) {
  const std::vector<Vec3>& positions = library.positions.front();
  BodyRig rig;
  for (int side = 0; side < 2; ++side) {
    const auto s = static_cast<std::size_t>(side);
    rig.arm[s] = arm_weight(library, side);
    rig.upper_arm[s] = ring(positions, side, kJointToRing - 0.03, kJointToRing + 0.03);
    rig.forearm[s] = ring(positions, side, 0.36, 0.42);
  }
  rig.crotch = find_crotch(positions);
  rig.hip = on_front(positions, 0.88);
  rig.belly = on_front(positions, 1.02);
  rig.chest = on_front(positions, 1.22);
  rig.neck = on_front(positions, 1.42);
  return rig;
}

Vec3 middle(const std::vector<int>& ring, const std::vector<Vec3>& positions) {
  Vec3 sum = Vec3::Zero();
  for (const int v : ring) sum += positions[static_cast<std::size_t>(v)];
  return sum / static_cast<double>(ring.size());
}

}  // namespace

double smooth_step(double from, double to, double value) {
  const double u = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

const BodyRig& body_rig() {
  static const BodyRig rig = make_rig(body_library());
  return rig;
}

BodyJoints body_joints(const BodyRig& rig, const std::vector<Vec3>& positions) {
  const auto height = [&](int v) { return positions[static_cast<std::size_t>(v)].y(); };
  BodyJoints out;
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec3 upper = middle(rig.upper_arm[side], positions);
    out.arm_along[side] = (middle(rig.forearm[side], positions) - upper).normalized();
    out.shoulder[side] = upper - kJointToRing * out.arm_along[side];
  }
  out.crotch = height(rig.crotch);
  out.hip = height(rig.hip);
  out.belly = height(rig.belly);
  out.chest = height(rig.chest);
  out.neck = height(rig.neck);
  return out;
}

}  // namespace regarment
