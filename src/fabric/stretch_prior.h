#pragma once

#include "fabric/dimension_role.h"
#include "garment/fabric.h"

namespace regarment {

/// What is believed of log(worn / flat) before the cloth is looked at: its logarithm is normal, for
/// stretch is a load (of one order of magnitude) over a stiffness (of another).
struct StretchPrior {
  double median = 0;  // of log(worn / flat)
  double spread = 0;  // standard deviation of its logarithm
  // Share of garments of which this holds; the others are loose there, hardly stretched at all.
  double tight = 1;
};

/// Share of strips that are tight among those whose cloth is longer by `fold` (a logarithm, >= 0)
/// than a tape pulled tight round it: loose cloth has folds and hollows.
double tight_share(double fold);

/// The medians are round figures of what tests/benchmarks/fabric_benchmark prints for made people,
/// and wide over fabrics: sheets of apparel have 100 to 5000 N/m.
/// `fold` as for tight_share, at the dimension's line.
StretchPrior stretch_prior(DimensionRole role, Fabric fabric, double fold);

}  // namespace regarment
