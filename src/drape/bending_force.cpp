#include "drape/bending_force.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace regarment {
namespace {

// Triangles lower than this share of their flat height weaken the bending modes.
constexpr double kLeastHeight = 0.1;

/// The state of one element: the angle and its gradient.
struct Fold {
  double angle = 0;         // theta, -pi..pi, positive where the cloth bulges outwards
  std::array<Vec3, 4> u{};  // dtheta / dx_i, 1/m
  bool valid = false;
};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// N / |N|^2, kept bounded where the triangle collapses.
Vec3 inverse(const Vec3& n, double rest) {
  const double least = kLeastHeight * rest;
  return n / std::max(n.squaredNorm(), least * least);
}

Fold fold_of(const Cloth& cloth, const BendingElement& e) {
  std::array<Vec3, 4> x;
  for (std::size_t k = 0; k < 4; ++k) x[k] = cloth.positions[index(e.particles[k])];
  const Vec3 side = x[3] - x[2];
  const double length = side.norm();
  const Vec3 n1 = (x[0] - x[2]).cross(x[0] - x[3]), n2 = (x[1] - x[3]).cross(x[1] - x[2]);
  Fold fold;
  if (!(length > 0) || !(n1.squaredNorm() > 0) || !(n2.squaredNorm() > 0)) return fold;
  const Vec3 along = side / length;
  fold.angle = std::atan2(n1.cross(n2).dot(along), n1.dot(n2));
  const Vec3 m1 = inverse(n1, e.rest_normals[0]), m2 = inverse(n2, e.rest_normals[1]);
  // A corner that moves outwards flattens a bulge: the gradient runs against the normals.
  fold.u[0] = -length * m1;
  fold.u[1] = -length * m2;
  fold.u[2] = -(x[0] - x[3]).dot(along) * m1 - (x[1] - x[3]).dot(along) * m2;
  fold.u[3] = (x[0] - x[2]).dot(along) * m1 + (x[1] - x[2]).dot(along) * m2;
  fold.valid = true;
  return fold;
}

/// |E|^2 / (|N1| + |N2|) of the flat cloth.
double shape_factor(const BendingElement& e) {
  return e.rest_side * e.rest_side / (e.rest_normals[0] + e.rest_normals[1]);
}

}  // namespace

double BendingForce::energy(const Cloth& cloth) const {
  double sum = 0;
  for (const BendingElement& e : cloth.bending) {
    const Fold fold = fold_of(cloth, e);
    if (fold.valid) sum += 2 * stiffness * shape_factor(e) * (1 - std::cos(fold.angle / 2));
  }
  return sum;
}

void BendingForce::add_forces(const Cloth& cloth, std::vector<Vec3>& forces) const {
  for (const BendingElement& e : cloth.bending) {
    const Fold fold = fold_of(cloth, e);
    if (!fold.valid) continue;
    double rate = 0;  // dtheta / dt
    for (std::size_t k = 0; k < 4; ++k)
      rate += fold.u[k].dot(cloth.velocities[index(e.particles[k])]);
    const double moment =
        stiffness * shape_factor(e) * std::sin(fold.angle / 2) + damping * e.rest_side * rate;
    for (std::size_t k = 0; k < 4; ++k) forces[index(e.particles[k])] -= moment * fold.u[k];
  }
}

void BendingForce::add_jacobian(const Cloth& cloth, ForceJacobian& jacobian) const {
  for (const BendingElement& e : cloth.bending) {
    const Fold fold = fold_of(cloth, e);
    if (!fold.valid) continue;
    const double elastic = stiffness * shape_factor(e) * 0.5 * std::cos(fold.angle / 2);
    const double damped = damping * e.rest_side;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        const Mat3 outer = fold.u[a] * fold.u[b].transpose();
        const int i = e.particles[a], j = e.particles[b];
        if (a == b) {
          jacobian.by_position.add(i, -elastic * outer);
          jacobian.by_velocity.add(i, -damped * outer);
        } else {
          jacobian.by_position.add(i, j, -elastic * outer);
          jacobian.by_velocity.add(i, j, -damped * outer);
        }
      }
  }
}

}  // namespace regarment
