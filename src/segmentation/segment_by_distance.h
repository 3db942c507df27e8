#pragma once

#include <vector>

#include "garment/pattern.h"
#include "segmentation/segment.h"

namespace regarment {

/// Gives every vertex that no garment has yet and that lies at most `threshold` metres from the
/// draped garment the label `layer` [Hasler et al. 2007, sec. 3.5]. `draped`: one position per
/// pattern vertex, body frame, m. Outliers keep label 0. Empty `labels` are made first: 0, and sure
/// of it.
/// The probability is one half at the threshold t. On the cloth it is 1 and falls as 1 - d / (2 t);
/// beyond t it rises as 1 - exp(1 - d / t) / 2. Of several garments' the smallest is kept.
/// Throws InvalidInput for a threshold that is not finite and > 0, sizes that do not match, layer
/// < 1 or > 255.
void segment_by_distance(const Scan& scan, const Pattern& pattern, const std::vector<Vec3>& draped,
                         double threshold, int layer, Labels& labels);

}  // namespace regarment
