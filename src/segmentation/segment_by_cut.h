#pragma once

#include <vector>

#include "segmentation/cut_evidence.h"

namespace regarment {

/// Gives vertices that no garment has yet the label `layer` by a minimum cut: each vertex is judged
/// by its distance from the draped garment, by where that garment's border and the edges seen on
/// the scan are, by its normal and its colour; a border costs its length, less along creases and
/// steps. Small islands go to what surrounds them.
///
/// `draped`: one position per pattern vertex, body frame, m. `parts`: as vertex_parts gives them.
/// A probability is how often labels of such evidence, their neighbours' included, were right on
/// made people: 0.5 to 0.99. Outliers keep label 0. Empty `labels` are made first: 0, and sure of
/// it. Of several garments' probabilities the smallest is kept. Throws InvalidInput for sizes that
/// do not match, layer < 1 or > 255, and options out of range.
void segment_by_cut(const Scan& scan, const std::vector<BodyPart>& parts,
                    const GarmentRegion& region, const Pattern& pattern,
                    const std::vector<Vec3>& draped, int layer, const CutOptions& options,
                    Labels& labels);

}  // namespace regarment
