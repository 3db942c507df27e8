#pragma once

#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "analysis/joint_start.h"
#include "joint/side_differences.h"

namespace regarment {

/// What may differ between a garment's sides and show on a scan: sleeves, and hems that are tilted.
std::vector<SidedDimension> sided_dimensions(const GarmentTemplate& garment, const JointFit& fit);

/// Those differences that exceed their spread, which is what garments with like sides show when
/// they are worn by made people. `starts`: as joint_starts() gives them; `fit`: of the first one.
/// Dimensions that are fixed are left out, and those whose edges may as well lie elsewhere.
std::vector<SideDifference> find_asymmetry(const GarmentTemplate& garment,
                                           const std::vector<JointStart>& starts,
                                           const JointFit& fit, const Stage& stage);

/// "T-shirt: its left side is 2.1 cm longer in sleeve length than its right one (give or take 1.3
/// cm)"
std::string asymmetry_in_words(const GarmentTemplate& garment, const SideDifference& difference);

}  // namespace regarment
