#include "segmentation/segment_by_distance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "geometry/closest_point.h"
#include "geometry/parallel.h"

namespace regarment {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr double kSure = 18;  // thresholds from the cloth; from there on a float's probability is 1

/// `share`: distance from the cloth over the threshold.
double probability(double share) {
  return share <= 1 ? 1 - 0.5 * share : 1 - 0.5 * std::exp(1 - share);
}

void require(bool right, const std::string& what) {
  if (!right) throw InvalidInput("segment_by_distance: " + what);
}

void check_input(const Scan& scan, const Pattern& pattern, const std::vector<Vec3>& draped,
                 double threshold, int layer, const Labels& labels) {
  const std::size_t n = scan.mesh.positions.size();
  require(std::isfinite(threshold) && threshold > 0,
          "the threshold is " + std::to_string(threshold) + " m, must be > 0");
  require(layer >= 1 && layer <= 255, "layer " + std::to_string(layer) + ", must be 1..255");
  require(draped.size() == pattern.flat.size(),
          std::to_string(draped.size()) + " draped positions for " +
              std::to_string(pattern.flat.size()) + " pattern vertices");
  require(scan.outlier.empty() || scan.outlier.size() == n, "one outlier mark per scan vertex");
  require(labels.label.size() == labels.probability.size() &&
              (labels.label.empty() || labels.label.size() == n),
          "one label and probability per scan vertex");
}

}  // namespace

void segment_by_distance(const Scan& scan, const Pattern& pattern, const std::vector<Vec3>& draped,
                         double threshold, int layer, Labels& labels) {
  check_input(scan, pattern, draped, threshold, layer, labels);
  const std::vector<Vec3>& positions = scan.mesh.positions;
  if (labels.label.empty()) {
    labels.label.assign(positions.size(), 0);
    labels.probability.assign(positions.size(), 1.0F);
  }
  const ClosestPoint cloth(draped, pattern.triangles);
  ClosestFilter near;
  near.max_distance = kSure * threshold;
  parallel_for(positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (labels.label[v] != 0 || (!scan.outlier.empty() && scan.outlier[v] != 0)) continue;
      const ClosestHit hit = cloth.closest(positions[v], near);
      if (!hit.found()) continue;
      const double distance = std::sqrt(hit.squared_distance);
      if (distance <= threshold) labels.label[v] = static_cast<std::uint8_t>(layer);
      labels.probability[v] =
          std::min(labels.probability[v], static_cast<float>(probability(distance / threshold)));
    }
  });
}

}  // namespace regarment
