#pragma once

#include <span>
#include <vector>

#include "scan/body_sample.h"
#include "scan/outer_sheet.h"

namespace regarment {

/// A person apart from what surrounds them in a scan.
struct SeparatedBody {
  BodySample sample;               // of the person alone
  std::vector<Belongs> belongs;    // per position
  std::vector<OuterSheet> sheets;  // floors and walls, in the frame of the positions
};

/// Takes floor and walls, posts, islands and stray points away from a person, so that they decide
/// nothing: not size, not axes, not where the floor is. What is found does not depend on the order
/// of positions, which must be finite and not empty.
SeparatedBody separate_body(std::span<const Vec3> positions, std::span<const Triangle> triangles);

}  // namespace regarment
