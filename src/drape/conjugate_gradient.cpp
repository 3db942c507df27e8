#include "drape/conjugate_gradient.h"

#include <Eigen/LU>

namespace regarment {
namespace {

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace

int ConjugateGradient::solve(const BlockMatrix& a, const std::vector<Vec3>& b, double tolerance,
                             int most_iterations, std::vector<Vec3>& x) {
  const std::size_t n = a.size();
  inverse_.resize(n);
  preconditioned_.resize(n);
  image_.resize(n);
  for (std::size_t i = 0; i < n; ++i) inverse_[i] = a.diagonal()[i].inverse();
  x.assign(n, Vec3::Zero());
  residual_ = b;
  for (std::size_t i = 0; i < n; ++i) preconditioned_[i].noalias() = inverse_[i] * residual_[i];
  direction_ = preconditioned_;
  double error = dot(residual_, preconditioned_);
  const double enough = tolerance * tolerance * error;
  int iterations = 0;
  while (error > enough && iterations < most_iterations) {
    a.multiply(direction_, image_);
    const double curvature = dot(direction_, image_);
    if (!(curvature > 0)) break;
    const double length = error / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += length * direction_[i];
      residual_[i] -= length * image_[i];
      preconditioned_[i].noalias() = inverse_[i] * residual_[i];
    }
    const double next = dot(residual_, preconditioned_);
    const double keep = next / error;
    for (std::size_t i = 0; i < n; ++i) direction_[i] = preconditioned_[i] + keep * direction_[i];
    error = next;
    ++iterations;
  }
  return iterations;
}

}  // namespace regarment
