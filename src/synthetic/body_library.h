#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Undressed people of one topology: vertex i is the same place of the body on each of them, and
/// the triangles are shared. Body frame: metres, +y up, +z where the person faces, +x to the
/// person's left, floor at y = 0; arms and legs apart, closed, outward triangles, alike left and
/// right.
struct BodyLibrary {
  std::vector<std::string> names;            // "female-average"
  std::vector<std::vector<Vec3>> positions;  // one list per body, equally long
  std::vector<Triangle> triangles;
};

/// Reads a library from its packed form (src/synthetic/bodies/README.md). Throws ReadError saying
/// what is wrong with it.
BodyLibrary unpack_bodies(std::span<const std::byte> packed);

/// The eight bodies compiled into the program. Any thread.
const BodyLibrary& body_library();

}  // namespace regarment
