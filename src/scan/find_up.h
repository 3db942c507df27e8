#pragma once

#include <optional>
#include <string>

#include "scan/body_sample.h"
#include "scan/person_likeness.h"

namespace regarment {

/// Which way is up, and what the shape looks like seen that way.
struct UpAxis {
  Vec3 direction = Vec3::UnitY();  // unit, in the file's frame
  std::string name;                // "+x" ... "-z", or "free" when no file axis is up
  double lead = 0.0;               // likeness over that of the next best direction; small is unsure
  BodySlices slices;               // across `direction`
  PersonLikeness likeness;
};

/// The direction in which a scan looks most like a standing person. A file axis unless the scan is
/// clearly tilted: either another direction looks far more like a person, or both feet stand on a
/// plane that no axis is perpendicular to. With `front` given only axes perpendicular to it are
/// tried.
UpAxis find_up(const BodySample& sample, const std::optional<Vec3>& front = std::nullopt);

/// The same for an axis someone has given.
UpAxis look_along(const BodySample& sample, const Vec3& up, std::string name);

}  // namespace regarment
