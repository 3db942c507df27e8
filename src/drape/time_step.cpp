#include "drape/time_step.h"

namespace regarment {
namespace {

constexpr int kMostIterations = 500;

}  // namespace

TimeStep::TimeStep(const Cloth& cloth) : system_(make_jacobian(cloth).by_position) {}

const std::vector<Vec3>& TimeStep::velocity_change(const Cloth& cloth,
                                                   const std::vector<Vec3>& forces,
                                                   const ForceJacobian& jacobian, double h,
                                                   double tolerance) {
  right_.resize(cloth.size());
  jacobian.by_position.multiply(cloth.velocities, right_);
  for (std::size_t i = 0; i < cloth.size(); ++i) right_[i] = h * (forces[i] + h * right_[i]);
  system_.combine(cloth.masses, h, jacobian.by_velocity, h * h, jacobian.by_position);
  iterations_ = solver_.solve(system_, right_, tolerance, kMostIterations, change_);
  return change_;
}

void advance(Cloth& cloth, const std::vector<Vec3>& velocity_change, double h) {
  for (std::size_t i = 0; i < cloth.size(); ++i) {
    cloth.velocities[i] += velocity_change[i];
    cloth.positions[i] += h * cloth.velocities[i];
  }
}

}  // namespace regarment
