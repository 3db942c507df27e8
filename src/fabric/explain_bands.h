#pragma once

#include <vector>

#include "fabric/hoop_bands.h"
#include "fabric/stretch_prior.h"

namespace regarment {

/// How much longer a dimension is worn than it lies flat.
struct Stretch {
  double mean = 0;                // worn / flat - 1
  double standard_deviation = 0;  // of the same
};

/// The stretch of each dimension of the family: prior times what the strips say. A strip has either
/// no strain, hanging loose, or some, and none is pushed together. So a strip that is short among
/// its neighbours bounds the stretch of all dimensions that its length depends on, and where
/// several agree on the shortest they are loose and give the flat garment. `priors`: one per
/// dimension of the family. Monte Carlo with a fixed seed: the same result every time.
std::vector<Stretch> explain_bands(const HoopFamily& family,
                                   const std::vector<StretchPrior>& priors, double cloth_error);

}  // namespace regarment
