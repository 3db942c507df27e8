#include <algorithm>

#include "analysis/stage.h"
#include "fit/person_outline.h"

namespace regarment {
namespace {

constexpr int kOutlineSize = 256;  // pixels, as the paper's search has by default

}  // namespace

std::vector<std::uint8_t> masked_parts(const Scan& scan, const std::vector<std::uint8_t>& caps) {
  if (scan.mesh.is_cloud()) return scan.outlier;
  std::vector<std::uint8_t> masked(scan.mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < masked.size(); ++t) {
    const Triangle& corners = scan.mesh.triangles[t];
    masked[t] = (t < caps.size() && caps[t] != 0) ||
                std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
                  return !scan.outlier.empty() && scan.outlier[v] != 0;
                });
  }
  return masked;
}

void judge_outlines(const Scan& scan, const std::vector<std::uint8_t>& caps,
                    std::vector<GarmentAnalysis>& garments) {
  const auto waits = [](const GarmentAnalysis& g) { return !g.trace && !g.draped.empty(); };
  if (std::none_of(garments.begin(), garments.end(), waits)) return;
  const PersonOutline person = outline_person(scan.mesh, masked_parts(scan, caps),
                                              kCloudSpacing * scan.facts.spacing, kOutlineSize);
  for (GarmentAnalysis& garment : garments)
    if (waits(garment))
      garment.silhouette = silhouette_error(person, garment.pattern.triangles, garment.draped);
}

}  // namespace regarment
