#include "scan/file_axis.h"

#include <cmath>

#include "base/error.h"

namespace regarment {

Vec3 axis_vector(std::string_view name) {
  for (std::size_t i = 0; i < kFileAxes.size(); ++i) {
    if (kFileAxes[i] != name) continue;
    Vec3 axis = Vec3::Zero();
    axis[static_cast<int>(i / 2)] = i % 2 == 0 ? 1.0 : -1.0;
    return axis;
  }
  throw UsageError("\"" + std::string(name) + "\" is no axis: use +x, -x, +y, -y, +z or -z");
}

std::string nearest_axis(const Vec3& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return std::string(kFileAxes[static_cast<std::size_t>(2 * axis + (direction[axis] < 0 ? 1 : 0))]);
}

}  // namespace regarment
