#pragma once

#include <map>
#include <string>
#include <vector>

#include "fabric/explain_bands.h"
#include "garment/fabric.h"
#include "garment/garment_template.h"
#include "garment/pattern.h"

namespace regarment {

struct StretchOptions {
  Fabric fabric = Fabric::Unknown;  // narrows the priors
  // m, root of the mean square by which the fitted cloth is off, smoothly, from the true one, 1e-5
  // .. 0.1. Larger trusts the cloth less and the priors more.
  double cloth_error = 0.003;

  void check() const;  // throws InvalidInput naming the field and its value
};

/// How much longer each dimension is worn than it lies flat, with its uncertainty: what turns
/// worn lengths seen on a scan into those of the flat garment, flat = worn / (1 + mean).
///
/// `worn`: dimensions as they lie on the body, m; `pattern`: flat at these; `draped`: one position
/// per pattern vertex, m, on the scan (any frame). The template's hoops are compared along the
/// cloth: a flat garment has straight sides, and cloth cannot be pushed together, so where the worn
/// one is narrower than its neighbours say, these are stretched (explain_bands). What no comparison
/// tells comes from priors that are wide over fabrics, narrower where the fabric is known.
///
/// Every dimension of the template is in the result. Throws InvalidInput when `draped` has not one
/// finite position per vertex or `worn` is no garment.
std::map<std::string, Stretch> worn_stretch(const GarmentTemplate& garment, const Dimensions& worn,
                                            const Pattern& pattern, const std::vector<Vec3>& draped,
                                            const StretchOptions& options = {});

}  // namespace regarment
