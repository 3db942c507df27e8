#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "fabric/dimension_role.h"
#include "fabric/free_girth.h"
#include "joint/joint_fit.h"
#include "measure/observe.h"

namespace regarment {

/// A dimension as it lies on the body.
struct WornEstimate {
  double value = 0;               // m
  double standard_deviation = 0;  // m
  double above = 0;               // m that its 90 % interval reaches further up than that
};

/// All that the joint fit and the scan tell of each worn dimension.
std::map<std::string, WornSources> worn_sources(const GarmentTemplate& garment, const JointFit& fit,
                                                const std::vector<ObservedLength>& observed);

/// One estimate from them. By the role of the dimension each source counts as it proved itself on
/// made people, and the deviation covers what their distances from each other did not
/// (tests/benchmarks/joint_calibration.py prints the figures). `tucked`: share of the edges behind
/// the dimension of which a part is hidden in an armpit, 0..1. All sources miss that part; how long
/// it is nothing shows, so that it counts as it does on made people, and may be much longer.
WornEstimate weigh(const WornSources& sources, DimensionRole role, double tucked = 0);

/// What `here` says of a circumference where armpits may hide cloth, and `free` where it hangs: the
/// more likely that one is not stretched, the more it counts.
WornEstimate weigh_free(const WornEstimate& here, const FreeGirth& free);

}  // namespace regarment
