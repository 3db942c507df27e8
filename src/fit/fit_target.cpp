#include "fit/fit_target.h"

#include <string>
#include <utility>

#include "base/error.h"

namespace regarment {
namespace {

ClosestPoint closest_points(const Mesh& scan, const std::vector<std::uint8_t>& masked) {
  if (scan.is_cloud()) return {std::span(scan.positions), std::span(scan.normals), masked};
  return {std::span(scan.positions), std::span(scan.triangles), masked};
}

}  // namespace

FitTarget::FitTarget(const Mesh& scan, const std::vector<std::uint8_t>& masked, double spacing,
                     int silhouette_size, std::vector<float> shares)
    : surface_(closest_points(scan, masked)), shares_(std::move(shares)) {
  const std::size_t elements = scan.is_cloud() ? scan.positions.size() : scan.triangles.size();
  if (!shares_.empty() && shares_.size() != elements)
    throw InvalidInput("FitTarget: " + std::to_string(shares_.size()) + " shares for " +
                       std::to_string(elements) + " parts of the scan");
  if (surface_.empty()) throw InvalidInput("FitTarget: the scan has no surface left to fit to");
  outline_ = outline_person(scan, masked, spacing, silhouette_size);
}

}  // namespace regarment
