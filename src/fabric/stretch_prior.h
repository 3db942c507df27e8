#pragma once

#include "fabric/dimension_role.h"
#include "garment/fabric.h"

namespace regarment {

/// What is believed of log(worn / flat) before the cloth is looked at: its logarithm is normal, for
/// stretch is a load (of one order of magnitude) over a stiffness (of another).
struct StretchPrior {
  double median = 0;  // of log(worn / flat)
  double spread = 0;  // standard deviation of its logarithm
};

/// Wide over fabrics: sheets of apparel have 100 to 5000 N/m.
StretchPrior stretch_prior(DimensionRole role, Fabric fabric);

}  // namespace regarment
