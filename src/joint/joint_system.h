#pragma once

#include <Eigen/Core>
#include <vector>

#include "joint/block_factor.h"
#include "joint/joint_model.h"

namespace regarment {

/// How far one step may go.
struct StepLimits {
  double position_spread =
      0.05;  // m, standard deviation of a particle's way as a prior of the step
  double dimension_spread = 0.05;  // m, the same of a dimension
  double longest = 0.05;           // m, the step is shortened until no particle goes further
};

/// One step of Gauss and Newton over particles and dimensions at once.
struct JointStep {
  std::vector<Vec3> positions;  // per particle, m to go
  Eigen::VectorXd dimensions;   // m to go
  bool shortened = false;       // by StepLimits::longest
};

/// Solves the joint model's normal equations: the particles' block by a sparse factorisation whose
/// structure is found once per pattern, the dimensions by their Schur complement (one three-column
/// back-substitution per dimension).
class JointSystem {
 public:
  explicit JointSystem(const JointModel& model);

  /// The step from `x`. `held`: per dimension, true = stays. Throws InvalidInput when the system
  /// cannot be factored.
  JointStep step(const JointModel& model, const std::vector<Vec3>& x, const std::vector<bool>& held,
                 const StepLimits& limits);

 private:
  void assemble(const JointModel& model, const std::vector<Vec3>& x, double position_weight);
  void add_springs(const JointModel& model, const std::vector<Vec3>& x);
  void add_hinges(const JointModel& model, const std::vector<Vec3>& x);
  void add_matches(const JointModel& model, const std::vector<Vec3>& x);
  void add_evidence(const JointModel& model);
  /// Eliminates the particles: schur_, and what is left of the gradient.
  void eliminate();

  int particles_;
  BlockTriangle matrix_;
  BlockFactor factor_;
  Eigen::VectorXd gradient_;                         // 3 n
  Eigen::MatrixXd mixed_, solved_;                   // 3 n x dimensions
  Eigen::VectorXd solved_gradient_;                  // 3 n
  Eigen::MatrixXd own_, schur_;                      // dimensions x dimensions
  Eigen::VectorXd own_gradient_, reduced_gradient_;  // dimensions
};

}  // namespace regarment
