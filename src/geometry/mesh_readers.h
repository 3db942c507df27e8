#pragma once

#include <string_view>

#include "geometry/mesh_builder.h"
#include "geometry/mesh_io.h"

namespace regarment {

// One reader per format, all behind `parse_mesh`. Each fills `builder` with the vertices and faces
// of `file`, in the file's order, and throws ReadError through it. Colours and normals go straight
// into `builder.mesh()`; when there is not one per vertex, `finish` drops them.

void read_ply(std::string_view file, MeshBuilder& builder);

}  // namespace regarment
