#pragma once

#include <map>
#include <string>
#include <vector>

#include "garment/pattern.h"
#include "geometry/point_tree.h"
#include "geometry/surface_samples.h"

namespace regarment {

struct LayOptions {
  int rounds = 60;      // of pulling and straightening. More settle further and cost time.
  double reach = 0.08;  // m, scan further away than this does not pull
  void check() const;   // throws InvalidInput
};

/// Lays a placed garment onto the scan without simulating cloth: particles are pulled to the
/// nearest cloth of the scan of similar normal, open edges to the edges found, and springs are
/// brought towards their flat lengths in turn. What the direct method shows as the worn garment.
///
/// `placed`: one position per pattern vertex, body frame, m. `cloth` marks the samples on the
/// garment. `edge_curves`: edge name -> closed curve found on the scan. Returns one position per
/// pattern vertex.
std::vector<Vec3> lay_on_scan(const Pattern& pattern, const std::vector<Vec3>& placed,
                              const SurfaceSamples& samples, const std::vector<std::uint8_t>& cloth,
                              const std::map<std::string, std::vector<Vec3>>& edge_curves,
                              const LayOptions& options = {});

}  // namespace regarment
