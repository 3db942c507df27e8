#include "fabric/stretch_prior.h"

#include <cmath>

namespace regarment {
namespace {

// Of a fabric that nobody named.
StretchPrior any_fabric(DimensionRole role) {
  switch (role) {
    case DimensionRole::BearingEdge:
      return {0.034, 0.6};
    case DimensionRole::TorsoEdge:
      return {0.0004, 1.0};
    case DimensionRole::LimbEdge:
      return {0.012, 1.1};
    case DimensionRole::Hoop:
      return {0.010, 0.9};
    case DimensionRole::Seam:
      return {0.012, 0.8};
    case DimensionRole::Length:
      return {0.0045, 0.8};
    case DimensionRole::WaistLength:
      return {0.0005, 1.0};
    case DimensionRole::LimbLength:
      break;
  }
  return {0.008, 1.0};
}

struct Give {
  double factor;  // of the median
  double spread;  // share of the spread that is left when the fabric is known
};

Give give(Fabric fabric) {
  switch (fabric) {
    case Fabric::Woven:
      return {0.6, 0.85};
    case Fabric::Jersey:
      return {1.5, 0.85};
    case Fabric::Elastic:
      return {2.5, 1.0};
    case Fabric::Unknown:
      break;
  }
  return {1.0, 1.0};
}

}  // namespace

double tight_share(double fold) {
  constexpr double kSmooth = 0.85;  // of strips without folds
  constexpr double kHalf = 0.02;    // fold at which half of these are left
  constexpr double kTransition = 0.006;
  constexpr double kLeast = 0.005;
  return kLeast + kSmooth / (1 + std::exp((fold - kHalf) / kTransition));
}

StretchPrior stretch_prior(DimensionRole role, Fabric fabric, double fold) {
  StretchPrior out = any_fabric(role);
  if (role == DimensionRole::Hoop) out.tight = tight_share(fold);
  const Give known = give(fabric);
  out.median *= known.factor;
  out.spread *= known.spread;
  return out;
}

}  // namespace regarment
