#include "report/close_holes.h"

#include <algorithm>

#include "analysis/stage.h"

namespace regarment {
namespace {

FillCloth cloth_of(const GarmentAnalysis& garment) {
  FillCloth out{garment.draped, garment.pattern.triangles, {}};
  for (const PatternEdge& edge : garment.pattern.edges) {
    std::vector<Vec3>& curve = out.edges.emplace_back();
    for (const int v : edge.vertices) curve.push_back(garment.draped[static_cast<std::size_t>(v)]);
  }
  return out;
}

}  // namespace

FilledScan close_holes(const Analysis& analysis) {
  std::vector<FillCloth> cloths;
  for (const GarmentAnalysis& garment : analysis.garments) cloths.push_back(cloth_of(garment));
  return fill_scan(analysis.scan.mesh, analysis.labels, analysis.scan.outlier, cloths,
                   kCloudSpacing * analysis.scan.facts.spacing);
}

std::size_t count_filled(const FilledScan& filled) {
  return static_cast<std::size_t>(
      std::count(filled.filled.begin(), filled.filled.end(), std::uint8_t{1}));
}

}  // namespace regarment
