#include "analysis/weigh_estimates.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace regarment {

std::map<std::string, WornEstimate> weigh_estimates(const GarmentTemplate& garment,
                                                    const JointFit& fit,
                                                    const std::vector<ObservedLength>& observed) {
  std::map<std::string, WornEstimate> out;
  Eigen::Index k = 0;
  for (const Dimension& d : garment.dimensions()) {
    const double theta = fit.dimensions.at(d.name);
    const auto line = fit.worn.find(d.name);
    const double drawn = line == fit.worn.end() ? theta : line->second;
    double seen = -1, deviation = -1;
    for (const ObservedLength& o : observed)
      if (o.seen && o.observation->equals == d.name)
        seen = o.value, deviation = o.standard_deviation;
    std::printf("@ %s %s %.5f %.5f %.5f %.5f %.5f %.4f %.5f\n", garment.name().c_str(),
                d.name.c_str(), 100 * theta, 100 * drawn, 100 * seen, 100 * deviation,
                100 * std::sqrt(fit.covariance(k, k)), fit.matched, 1000 * fit.surface_error);
    ++k;
    out[d.name] = {drawn, 0.01};
  }
  return out;
}

}  // namespace regarment
