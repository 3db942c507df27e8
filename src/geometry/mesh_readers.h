#pragma once

#include <string_view>

#include "geometry/mesh_builder.h"
#include "geometry/mesh_io.h"

namespace regarment {

// One reader per format, all behind `parse_mesh`. Each fills `builder` with the vertices and faces
// of `file`, in the file's order, and throws ReadError through it. Colours and normals go straight
// into `builder.mesh()`; when there is not one per vertex, `finish` drops them.

void read_ply(std::string_view file, MeshBuilder& builder);
void read_obj(std::string_view file, MeshBuilder& builder);
void read_off(std::string_view file, MeshBuilder& builder);
/// Text and binary, three vertices per facet. The facets' normals are not taken over.
void read_stl(std::string_view file, MeshBuilder& builder);
/// glTF 2.0 and GLB, by assimp. One run of vertices per primitive, as long as its POSITION
/// accessor, nodes depth first in the scene's order, moved by the nodes' transforms. No file is
/// ever opened.
void read_gltf(std::string_view file, MeshBuilder& builder);

}  // namespace regarment
