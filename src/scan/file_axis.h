#pragma once

#include <array>
#include <string>
#include <string_view>

#include "geometry/mesh.h"

namespace regarment {

inline constexpr std::array<std::string_view, 6> kFileAxes = {"+x", "-x", "+y", "-y", "+z", "-z"};

/// Unit vector of a signed file axis, "+x" ... "-z". Throws UsageError for anything else.
Vec3 axis_vector(std::string_view name);

/// The signed file axis nearest to a direction, by angle.
std::string nearest_axis(const Vec3& direction);

}  // namespace regarment
