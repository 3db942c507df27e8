#include "joint/joint_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace regarment {
namespace {

/// Area of cloth per spring: a third of each triangle it is a side of.
std::vector<double> spring_areas(const Pattern& pattern, const std::vector<Spring>& springs) {
  const std::vector<double> areas = triangle_areas(pattern);
  std::vector<double> out(springs.size(), 0.0);
  using Ends = std::pair<int, int>;
  for (std::size_t f = 0; f < areas.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      const Ends side = std::minmax({pattern.particle[pattern.triangles[f][c]],
                                     pattern.particle[pattern.triangles[f][(c + 1) % 3]]});
      const auto spring = std::lower_bound(springs.begin(), springs.end(), side,
                                           [](const Spring& s, const Ends& ends) {
                                             return Ends{s.particle_a, s.particle_b} < ends;
                                           });
      out[static_cast<std::size_t>(spring - springs.begin())] += areas[f] / 3;
    }
  return out;
}

double squared(double a) { return a * a; }

}  // namespace

JointModel::JointModel(const GarmentTemplate& garment, const Dimensions& start, double edge_length,
                       const JointScales& scales)
    : garment_(garment),
      scales_(scales),
      dimensions_(start),
      pattern_(make_pattern(garment, start, edge_length)),
      springs_(regarment::springs(pattern_)) {
  move_to(start);
  const auto n = static_cast<Eigen::Index>(dimension_count());
  prior_mean.resize(n), prior_weight.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Dimension& d = garment_.dimensions()[static_cast<std::size_t>(k)];
    prior_mean[k] = d.typical;
    prior_weight[k] = 1 / squared(scales_.prior_share * (d.upper - d.lower));
  }
}

void JointModel::move_to(const Dimensions& dimensions) {
  move_pattern(garment_, dimensions, pattern_);
  dimensions_ = dimensions;
  update_rest_lengths(pattern_, springs_);
  flat_slopes_ = flat_slopes(garment_, dimensions_, pattern_);
  slopes_ = rest_length_slopes(flat_slopes_, pattern_, springs_);
  const std::vector<double> areas = spring_areas(pattern_, springs_);
  spring_weights_.resize(springs_.size());
  for (std::size_t s = 0; s < springs_.size(); ++s)
    spring_weights_[s] =
        areas[s] / scales_.patch / squared(scales_.strain * springs_[s].rest_length);
  hinges_ = regarment::hinges(pattern_);
  hinge_weights_.clear();
  for (const Hinge& h : hinges_)
    hinge_weights_.push_back(h.area / scales_.patch / squared(scales_.curvature));
  particle_areas_ = particle_masses(pattern_, 1.0);
}

void JointModel::add_slopes(const FlatSlopes& more, double spread) {
  const auto before = static_cast<Eigen::Index>(dimension_count());
  for (std::size_t k = 0; k < more.size(); ++k) {
    flat_slopes_.names.push_back(more.names[k]);
    flat_slopes_.vertex.push_back(more.vertex[k]);
    dimensions_[more.names[k]] = 0;
  }
  slopes_ = rest_length_slopes(flat_slopes_, pattern_, springs_);
  const auto added = static_cast<Eigen::Index>(more.size());
  prior_mean.conservativeResize(before + added);
  prior_weight.conservativeResize(before + added);
  prior_mean.tail(added).setZero();
  prior_weight.tail(added).setConstant(1 / squared(spread));
}

void JointModel::shift(const Eigen::VectorXd& step) {
  const std::size_t n = dimension_count();
  for (std::size_t s = 0; s < springs_.size(); ++s)
    for (std::size_t k = 0; k < n; ++k)
      springs_[s].rest_length += slopes_[s * n + k] * step[static_cast<Eigen::Index>(k)];
  for (std::size_t k = 0; k < n; ++k)
    dimensions_[flat_slopes_.names[k]] += step[static_cast<Eigen::Index>(k)];
}

double JointModel::energy(const std::vector<Vec3>& x, const Eigen::VectorXd& step) const {
  const std::size_t n = dimension_count();
  double sum = 0;
  for (std::size_t s = 0; s < springs_.size(); ++s) {
    double rest = springs_[s].rest_length / arc(s);
    for (std::size_t k = 0; k < n; ++k)
      rest += slopes_[s * n + k] / arc(s) * step[static_cast<int>(k)];
    const double length = (x[springs_[s].particle_b] - x[springs_[s].particle_a]).norm();
    sum += spring_weight(s) * squared(length - rest);
  }
  for (std::size_t h = 0; h < hinges_.size(); ++h) {
    Vec3 curvature = Vec3::Zero();
    for (int c = 0; c < 4; ++c) curvature += hinges_[h].weights[c] * x[hinges_[h].particles[c]];
    sum += hinge_weights_[h] * curvature.squaredNorm();
  }
  for (const SurfaceMatch& m : surface) {
    Vec3 at = -m.point;
    for (int c = 0; c < 3; ++c) at += m.share[c] * x[m.particles[c]];
    sum += m.weight * squared(m.normal.dot(at));
  }
  for (const EdgeMatch& e : edges) sum += e.weight * squared(e.across.dot(x[e.particle] - e.point));
  for (const InsideBound& b : inside)
    sum += b.weight * squared(std::max(0.0, b.outward.dot(x[b.particle] - b.point)));
  for (const LengthEvidence& o : lengths)
    sum += squared((o.at_model + o.slope.dot(step) - o.value) / o.standard_deviation);
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    sum +=
        prior_weight[i] * squared(dimensions_.at(flat_slopes_.names[k]) + step[i] - prior_mean[i]);
  }
  return sum / 2;
}

Eigen::VectorXd JointModel::dimension_gradient(const std::vector<Vec3>& x) const {
  const std::size_t n = dimension_count();
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
  for (std::size_t s = 0; s < springs_.size(); ++s) {
    const Spring& spring = springs_[s];
    const double over =
        (x[spring.particle_b] - x[spring.particle_a]).norm() - spring.rest_length / arc(s);
    for (std::size_t k = 0; k < n; ++k)
      gradient[static_cast<int>(k)] -= spring_weight(s) * over * slopes_[s * n + k] / arc(s);
  }
  for (const LengthEvidence& o : lengths)
    gradient += (o.at_model - o.value) / squared(o.standard_deviation) * o.slope;
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    gradient[i] += prior_weight[i] * (dimensions_.at(flat_slopes_.names[k]) - prior_mean[i]);
  }
  return gradient;
}

}  // namespace regarment
