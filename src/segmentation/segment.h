#pragma once

#include <cstdint>
#include <vector>

#include "measure/garment_region.h"
#include "scan/scan.h"

namespace regarment {

/// A label for each vertex of a scan.
struct Labels {
  std::vector<std::uint8_t> label;  // 0 person, i = i-th garment, outermost first
  std::vector<float> probability;   // that the label is right, 0.5..1
};

/// Where each vertex of a scan's file lies on the body: from the samples nearest to it. Vertices
/// without a sample (used by no triangle, outliers) are Loose.
std::vector<BodyPart> vertex_parts(const Scan& scan, const SurfaceSamples& samples,
                                   const Body& body);

/// Gives every vertex that no garment has yet and that lies between the edges of this one the label
/// `layer`. Probability falls to one half at the border: 1 - exp(-d / 1 cm) / 2 at distance d from
/// it.
void label_region(const Scan& scan, const std::vector<BodyPart>& parts, const GarmentRegion& region,
                  int layer, Labels& labels);

}  // namespace regarment
