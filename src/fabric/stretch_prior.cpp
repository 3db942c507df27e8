#include "fabric/stretch_prior.h"

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
      return {0.0025, 1.5};
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

StretchPrior stretch_prior(DimensionRole role, Fabric fabric) {
  StretchPrior out = any_fabric(role);
  const Give known = give(fabric);
  out.median *= known.factor;
  out.spread *= known.spread;
  return out;
}

}  // namespace regarment
