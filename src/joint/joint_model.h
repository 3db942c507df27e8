#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "garment/pattern.h"
#include "garment/springs.h"
#include "joint/flat_slopes.h"
#include "joint/hinges.h"

namespace regarment {

/// A point of the scan and where on the garment it lies.
struct SurfaceMatch {
  std::array<int, 3> particles{};  // corners of the garment's triangle
  Vec3 share = Vec3::Zero();       // barycentric
  Vec3 point = Vec3::Zero();       // of the scan, body frame, m
  Vec3 normal = Vec3::Zero();      // unit; distance counts along it, the garment slides across
  double weight = 0;               // 1/m^2
};

/// A particle of an open edge and where the scan shows this edge.
struct EdgeMatch {
  int particle = 0;
  Vec3 point = Vec3::Zero();   // on the edge seen, m
  Vec3 across = Vec3::Zero();  // unit; distance counts along it
  double weight = 0;           // 1/m^2
};

/// A particle under another garment and where that one's inner side is.
struct InsideBound {
  int particle = 0;
  Vec3 point = Vec3::Zero();    // on the inner side, m
  Vec3 outward = Vec3::Zero();  // unit; beyond the point in this direction the particle is pushed
                                // back, on this side it is free
  double weight = 0;            // 1/m^2
};

/// A length that was measured: dimensions that explain it are likely.
struct LengthEvidence {
  double value = 0;               // m, as measured
  double standard_deviation = 0;  // m, > 0
  double at_model = 0;            // m, by the template's formula at the model's dimensions
  Eigen::VectorXd slope;          // d formula / d dimension, in the template's order
};

/// How much of what counts as one standard deviation. Quantities spread over the cloth count once
/// per `patch`, since neighbours err alike.
struct JointScales {
  double strain = 0.04;       // of a spring
  double curvature = 80;      // 1/m, of a hinge
  double surface = 0.001;     // m, scan off the garment
  double patch = 9e-4;        // m^2
  double edge_parts = 4;      // independent parts of a loop
  double prior_share = 0.25;  // of a dimension's bounds
};

/// The energy of the joint fit: particles x and dimensions theta at once.
///
///   E(x, theta) = 1/2 sum_s w_s (|x_b - x_a| - l_s(theta))^2         springs of the flat garment
///               + 1/2 sum_h w_h |curvature_h(x)|^2                    bending
///               + 1/2 sum_m w_m (n_m . (x(m) - p_m))^2                scan on the garment
///               + 1/2 sum_e w_e (c_e . (x_e - q_e))^2                 edges seen
///               + 1/2 sum_b w_b max(0, n_b . (x_b - p_b))^2           under another garment
///               + 1/2 sum_o ((f_o(theta) - value_o) / sd_o)^2         lengths measured
///               + 1/2 sum_k ((theta_k - typical_k) / spread_k)^2      prior, wide
///
/// Rest lengths are linear in theta about the dimensions the model stands at (exactly so for most
/// of a pattern); `move_to` stands it elsewhere.
class JointModel {
 public:
  JointModel(const GarmentTemplate& garment, const Dimensions& start, double edge_length,
             const JointScales& scales);

  /// Takes the flat garment at other dimensions. Throws InvalidInput when they make none.
  void move_to(const Dimensions& dimensions);

  /// Takes in more ways in which the flat garment may change, as dimensions after the template's
  /// own, at 0 with the standard deviation `spread` (m) about it. They stay until move_to().
  void add_slopes(const FlatSlopes& more, double spread);
  /// Moves all dimensions (m, those added too) where the rest lengths are taken to be linear.
  void shift(const Eigen::VectorXd& step);

  const GarmentTemplate& garment() const { return garment_; }
  const Pattern& pattern() const { return pattern_; }
  const Dimensions& dimensions() const { return dimensions_; }
  const JointScales& scales() const { return scales_; }
  const std::vector<Spring>& springs() const { return springs_; }
  /// 1/m^2, with what `slack` leaves of it.
  double spring_weight(std::size_t s) const {
    return spring_weights_[s] * (slack.empty() ? 1.0 : slack[s]);
  }
  const std::vector<double>& slopes() const { return slopes_; }  // rest_length_slopes
  const std::vector<Hinge>& hinges() const { return hinges_; }
  const std::vector<double>& hinge_weights() const { return hinge_weights_; }    // m^2
  const std::vector<double>& particle_areas() const { return particle_areas_; }  // m^2
  std::size_t dimension_count() const { return flat_slopes_.size(); }
  const FlatSlopes& flat() const { return flat_slopes_; }

  std::vector<SurfaceMatch> surface;
  std::vector<EdgeMatch> edges;
  std::vector<InsideBound> inside;
  std::vector<LengthEvidence> lengths;
  std::vector<double> arcs;  // per spring: length of the cloth over its chord; empty: all 1
  Eigen::VectorXd prior_mean, prior_weight;  // per dimension, m and 1/m^2

  std::vector<double> slack;  // per spring: share of its weight that counts; empty: all of it

  /// Length of a spring's cloth over its chord.
  double arc(std::size_t spring) const { return arcs.empty() ? 1.0 : arcs[spring]; }

  /// E at particles `x`, with the dimensions moved by `step` (m) from where the model stands.
  double energy(const std::vector<Vec3>& x, const Eigen::VectorXd& step) const;
  /// dE / d dimension at `x`, where the model stands. Where x minimises E this is the slope of the
  /// re-solved energy (envelope theorem).
  Eigen::VectorXd dimension_gradient(const std::vector<Vec3>& x) const;

 private:
  GarmentTemplate garment_;
  JointScales scales_;
  Dimensions dimensions_;
  Pattern pattern_;
  std::vector<Spring> springs_;
  std::vector<double> spring_weights_, slopes_, hinge_weights_, particle_areas_;
  std::vector<Hinge> hinges_;
  FlatSlopes flat_slopes_;
};

}  // namespace regarment
