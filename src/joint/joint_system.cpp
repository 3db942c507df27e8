#include "joint/joint_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace regarment {
namespace {

using Index = Eigen::Index;

/// First of a particle's three rows.
constexpr Index row_of(int particle) { return 3 * static_cast<Index>(particle); }

std::vector<std::array<int, 2>> spring_pairs(const JointModel& model) {
  std::vector<std::array<int, 2>> pairs;
  pairs.reserve(model.springs().size());
  for (const Spring& s : model.springs()) pairs.push_back({s.particle_a, s.particle_b});
  return pairs;
}

}  // namespace

JointSystem::JointSystem(const JointModel& model)
    : particles_(model.pattern().particle_count),
      matrix_(particles_, spring_pairs(model)),
      factor_(matrix_) {}

void JointSystem::add_springs(const JointModel& model, const std::vector<Vec3>& x) {
  const std::size_t n = model.dimension_count();
  for (std::size_t s = 0; s < model.springs().size(); ++s) {
    const Spring& spring = model.springs()[s];
    const Vec3 d = x[spring.particle_b] - x[spring.particle_a];
    const double length = d.norm(), w = model.spring_weight(s);
    if (length < 1e-9) continue;
    const Vec3 along = d / length;
    const double arc = model.arc(s), rest = spring.rest_length / arc;
    // A stretched spring also resists being turned.
    const double across = std::max(0.0, 1 - rest / length);
    const Eigen::Matrix3d block =
        w * (across * Eigen::Matrix3d::Identity() + (1 - across) * along * along.transpose());
    matrix_.add(spring.particle_a, spring.particle_a, block);
    matrix_.add(spring.particle_b, spring.particle_b, block);
    matrix_.add(spring.particle_b, spring.particle_a, -block);
    const Vec3 force = w * (length - rest) * along;
    gradient_.segment<3>(row_of(spring.particle_a)) -= force;
    gradient_.segment<3>(row_of(spring.particle_b)) += force;
    for (std::size_t k = 0; k < n; ++k) {
      const double slope = model.slopes()[s * n + k] / arc;
      const auto column = static_cast<Index>(k);
      mixed_.col(column).segment<3>(row_of(spring.particle_a)) += w * slope * along;
      mixed_.col(column).segment<3>(row_of(spring.particle_b)) -= w * slope * along;
      for (std::size_t m = 0; m <= k; ++m)
        own_(column, static_cast<Index>(m)) += w * slope * model.slopes()[s * n + m] / arc;
    }
  }
}

void JointSystem::add_hinges(const JointModel& model, const std::vector<Vec3>& x) {
  for (std::size_t h = 0; h < model.hinges().size(); ++h) {
    const Hinge& hinge = model.hinges()[h];
    Vec3 curvature = Vec3::Zero();
    for (int c = 0; c < 4; ++c) curvature += hinge.weights[c] * x[hinge.particles[c]];
    for (int a = 0; a < 4; ++a) {
      const double w = model.hinge_weights()[h] * hinge.weights[a];
      gradient_.segment<3>(row_of(hinge.particles[a])) += w * curvature;
      for (int b = 0; b < 4; ++b) {
        // The corners opposite to the side are joined by no spring; joining them here would cost
        // several times as much to factor. 2 x0 x1 <= x0^2 + x1^2 takes their term's place, with
        // nothing in the way of moves that both make.
        const bool opposite = a + b == 1;
        matrix_.add(hinge.particles[a], hinge.particles[opposite ? a : b],
                    w * hinge.weights[b] * Eigen::Matrix3d::Identity());
      }
    }
  }
}

void JointSystem::add_matches(const JointModel& model, const std::vector<Vec3>& x) {
  for (const SurfaceMatch& m : model.surface) {
    Vec3 at = -m.point;
    for (int c = 0; c < 3; ++c) at += m.share[c] * x[m.particles[c]];
    const double off = m.normal.dot(at);
    const Eigen::Matrix3d block = m.weight * m.normal * m.normal.transpose();
    for (int a = 0; a < 3; ++a) {
      gradient_.segment<3>(row_of(m.particles[a])) += m.weight * m.share[a] * off * m.normal;
      for (int b = 0; b < 3; ++b)
        matrix_.add(m.particles[a], m.particles[b], m.share[a] * m.share[b] * block);
    }
  }
  for (const EdgeMatch& e : model.edges) {
    const double off = e.across.dot(x[e.particle] - e.point);
    gradient_.segment<3>(row_of(e.particle)) += e.weight * off * e.across;
    matrix_.add(e.particle, e.particle, e.weight * e.across * e.across.transpose());
  }
  for (const InsideBound& b : model.inside) {
    const double beyond = b.outward.dot(x[b.particle] - b.point);
    if (beyond <= 0) continue;
    gradient_.segment<3>(row_of(b.particle)) += b.weight * beyond * b.outward;
    matrix_.add(b.particle, b.particle, b.weight * b.outward * b.outward.transpose());
  }
}

void JointSystem::add_evidence(const JointModel& model) {
  for (const LengthEvidence& o : model.lengths)
    own_ += o.slope * o.slope.transpose() / (o.standard_deviation * o.standard_deviation);
  own_.diagonal() += model.prior_weight;
}

void JointSystem::assemble(const JointModel& model, const std::vector<Vec3>& x,
                           double position_weight) {
  const auto n = static_cast<Index>(model.dimension_count());
  matrix_.set_zero();
  gradient_.setZero(row_of(particles_));
  mixed_.setZero(row_of(particles_), n);
  own_.setZero(n, n);
  add_springs(model, x);
  own_.triangularView<Eigen::StrictlyUpper>() = own_.transpose();
  add_hinges(model, x);
  add_matches(model, x);
  add_evidence(model);
  for (int i = 0; i < particles_; ++i)
    matrix_.add(i, i,
                position_weight * model.particle_areas()[i] / model.scales().patch *
                    Eigen::Matrix3d::Identity());
  own_gradient_ = model.dimension_gradient(x);
  if (!factor_.factorize(matrix_))
    throw InvalidInput("the joint system of the garment cannot be factored");
}

void JointSystem::eliminate() {
  Eigen::MatrixXd right(mixed_.rows(), mixed_.cols() + 1);
  right << mixed_, gradient_;
  right = factor_.solve(right);
  solved_ = right.leftCols(mixed_.cols());
  solved_gradient_ = right.rightCols<1>();
  schur_ = own_ - mixed_.transpose() * solved_;
  reduced_gradient_ = own_gradient_ - mixed_.transpose() * solved_gradient_;
}

JointStep JointSystem::step(const JointModel& model, const std::vector<Vec3>& x,
                            const std::vector<bool>& held, const StepLimits& limits) {
  assemble(model, x, 1 / (limits.position_spread * limits.position_spread));
  eliminate();
  for (Index k = 0; k < schur_.rows(); ++k) {
    schur_(k, k) += 1 / (limits.dimension_spread * limits.dimension_spread);
    if (!held[static_cast<std::size_t>(k)]) continue;
    schur_.row(k).setZero(), schur_.col(k).setZero();
    schur_(k, k) = 1, reduced_gradient_[k] = 0;
  }
  JointStep out;
  out.dimensions = -schur_.ldlt().solve(reduced_gradient_);
  const Eigen::VectorXd way = -solved_gradient_ - solved_ * out.dimensions;
  double longest = 0;
  for (int i = 0; i < particles_; ++i) {
    out.positions.emplace_back(way.segment<3>(row_of(i)));
    longest = std::max(longest, out.positions.back().norm());
  }
  if (!(longest > limits.longest)) return out;
  out.shortened = true;
  const double share = limits.longest / longest;
  for (Vec3& p : out.positions) p *= share;
  out.dimensions *= share;
  return out;
}

}  // namespace regarment
