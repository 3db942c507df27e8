#pragma once

#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "measure/garment_edges.h"

namespace regarment {

/// One observation of the template as measured on the scan.
struct ObservedLength {
  const Observation* observation = nullptr;
  double value = 0;               // m, worn; of an unseen path what shows of it, or 0
  double standard_deviation = 0;  // m
  bool seen = false;              // false: the scan does not show it
  bool hanging = false;           // runs along folds that hang, where levels miss cloth
};

/// Measures what the template says can be seen, on the garment between the edges found. `cloth`
/// marks the samples on the garment, one per sample. One entry per observation of the template, in
/// its order.
std::vector<ObservedLength> observe(const SurfaceSamples& samples, const Body& body,
                                    const GarmentEdges& edges,
                                    const std::vector<std::uint8_t>& cloth,
                                    const GarmentTemplate& garment);

/// The dimensions that explain the observed lengths best (weighted least squares by Gauss-Newton
/// from the typical ones, within the bounds), with their standard deviations. A dimension that no
/// seen observation depends on keeps its typical value and is not observable. Those in `fixed` (m,
/// by name, within their bounds) are known: they keep their value, without a deviation, and the
/// others explain what is left.
struct SolvedDimension {
  double value = 0;               // m
  double standard_deviation = 0;  // m
  bool observable = false;
};
std::map<std::string, SolvedDimension> solve_dimensions(const GarmentTemplate& garment,
                                                        const std::vector<ObservedLength>& observed,
                                                        const Dimensions& fixed = {});

}  // namespace regarment
