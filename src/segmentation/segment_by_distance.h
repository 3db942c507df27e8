#pragma once

#include <vector>

#include "garment/pattern.h"
#include "segmentation/segment.h"

namespace regarment {

/// Gives every vertex that no garment has yet and that lies at most `threshold` metres from the
/// draped garment the label `layer` [Hasler et al. 2007, sec. 3.5]. `draped`: one position per
/// pattern vertex, body frame, m. Outliers keep label 0. Probability falls from 1 on the cloth, and
/// far from it, to one half at the threshold. Throws InvalidInput for a threshold that is not > 0,
/// sizes that do not match, layer < 1 or > 255.
void segment_by_distance(const Scan& scan, const Pattern& pattern, const std::vector<Vec3>& draped,
                         double threshold, int layer, Labels& labels);

}  // namespace regarment
