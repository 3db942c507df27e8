#pragma once

#include <string>
#include <vector>

#include "joint/joint_model.h"

namespace regarment {

/// A length of the worn garment that was measured before.
struct MeasuredLength {
  std::string formula;            // over the template's dimensions
  double value = 0;               // m
  double standard_deviation = 0;  // m, > 0
};

/// What measured lengths say of a model that stands at the dimensions `at`.
std::vector<LengthEvidence> length_evidence(const GarmentTemplate& garment, const Dimensions& at,
                                            const std::vector<MeasuredLength>& lengths);

}  // namespace regarment
