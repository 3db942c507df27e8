#pragma once

#include <map>
#include <string>
#include <vector>

#include "fabric/worn_stretch.h"
#include "joint/joint_fit.h"
#include "measure/observe.h"

namespace regarment {

/// A dimension as it lies on the body.
struct WornEstimate {
  double value = 0;               // m
  double standard_deviation = 0;  // m
};

/// The worn dimensions from all that tells of them: the dimensions of the joint fit, the template's
/// lines on its draped cloth, and what was measured on the scan itself; each counts by how far it
/// was off on people made with known truth (tests/benchmarks/joint_calibration.py), more where the
/// three disagree.
std::map<std::string, WornEstimate> weigh_estimates(const GarmentTemplate& garment,
                                                    const JointFit& fit,
                                                    const std::vector<ObservedLength>& observed);

}  // namespace regarment
