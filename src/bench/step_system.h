#pragma once

#include <Eigen/SparseCore>

#include "joint/block_factor.h"
#include "joint/joint_model.h"

namespace regarment {

/// 1/m^2: what holds a particle in a step that may go 5 cm, and across a scan known to a
/// millimetre.
inline constexpr double kStepPull = 400, kStepAcross = 1e6;

/// The linear system of a step of the joint fit, for measuring what solves it: springs, the scan's
/// pull across the cloth and a weak pull to where each particle is, of a garment rolled round a
/// trunk, so that springs and normals point in all directions. Both forms hold the same numbers.
struct StepSystem {
  BlockTriangle blocks;
  Eigen::SparseMatrix<double> matrix;  // 3 n x 3 n, both triangles
  Eigen::MatrixXd right;               // 3 n rows, a column per dimension and one more
};

StepSystem step_system(const JointModel& model);

}  // namespace regarment
