#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "fabric/dimension_role.h"
#include "joint/joint_fit.h"
#include "measure/observe.h"

namespace regarment {

/// A dimension as it lies on the body.
struct WornEstimate {
  double value = 0;               // m
  double standard_deviation = 0;  // m
};

/// All that the joint fit and the scan tell of each worn dimension.
std::map<std::string, WornSources> worn_sources(const GarmentTemplate& garment, const JointFit& fit,
                                                const std::vector<ObservedLength>& observed);

/// One estimate from them. By the role of the dimension each source counts as it proved itself on
/// made people, and the deviation covers what their distances from each other did not
/// (tests/benchmarks/joint_calibration.py prints the figures).
WornEstimate weigh(const WornSources& sources, DimensionRole role);

}  // namespace regarment
