#include "segmentation/segment.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/parallel.h"

namespace regarment {
namespace {

constexpr double kDoubt = 0.01;  // m from the border at which the probability has risen to 0.82
constexpr std::size_t kGrain = 4096;

}  // namespace

std::vector<BodyPart> vertex_parts(const Scan& scan, const SurfaceSamples& samples,
                                   const Body& body) {
  if (body.part.size() != samples.size()) throw InvalidInput("vertex_parts: one part per sample");
  std::vector<BodyPart> parts(scan.mesh.positions.size(), BodyPart::Loose);
  for (std::size_t s = 0; s < samples.size(); ++s)
    if (body.part[s] != BodyPart::Loose) parts[samples.vertex[s]] = body.part[s];
  return parts;
}

void label_region(const Scan& scan, const std::vector<BodyPart>& parts, const GarmentRegion& region,
                  int layer, Labels& labels) {
  const std::size_t n = scan.mesh.positions.size();
  if (labels.label.empty()) {
    labels.label.assign(n, 0);
    labels.probability.assign(n, 1.0F);
  }
  parallel_for(n, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (labels.label[v] != 0 || (!scan.outlier.empty() && scan.outlier[v] != 0)) continue;
      const double depth = region.depth(scan.mesh.positions[v], parts[v]);
      if (depth > 0) labels.label[v] = static_cast<std::uint8_t>(layer);
      const double sure = 1 - 0.5 * std::exp(-std::abs(depth) / kDoubt);
      labels.probability[v] = std::min(labels.probability[v], static_cast<float>(sure));
    }
  });
}

}  // namespace regarment
