#pragma once

#include <optional>
#include <span>

#include "geometry/mesh.h"

namespace regarment {

/// The plane both feet stand flat on, where it is clearly another than the one across `up`: its
/// unit normal, on the side of the body. Looks at planes tilted by up to 35 degrees. Nothing when
/// the feet already stand flat across `up`, when they are not there, or when they do not share a
/// plane (walking, dancing).
std::optional<Vec3> standing_plane(std::span<const Vec3> points, const Vec3& up, double height);

}  // namespace regarment
