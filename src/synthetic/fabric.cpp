#include "synthetic/fabric.h"

#include <cmath>
#include <string>

#include "base/error.h"

namespace regarment {
namespace {

void check_range(const char* name, double value, double low, double high) {
  if (std::isfinite(value) && value >= low && value <= high) return;
  throw InvalidInput("fabric " + std::string(name) + " is " + std::to_string(value) +
                     ", it must be " + std::to_string(low) + " to " + std::to_string(high));
}

}  // namespace

void SheetFabric::check() const {
  check_range("thickness", thickness, 5e-4, 0.01);
  check_range("density", density, 0.02, 2.0);
  check_range("stiffness_along", stiffness_along, 5.0, 1e5);
  check_range("stiffness_across", stiffness_across, 5.0, 1e5);
  check_range("stiffness_shear", stiffness_shear, 1.0, 1e5);
  check_range("bending", bending, 0.0, 1e-2);
  check_range("friction", friction, 0.0, 2.0);
}

}  // namespace regarment
