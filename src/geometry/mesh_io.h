#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "geometry/mesh.h"

namespace regarment {

enum class MeshFormat { Ply, Obj, Off, Stl, Glb, Gltf };

/// Limits a reader holds whatever the file promises.
struct MeshReadLimits {
  std::size_t max_vertices = 20'000'000;
  std::size_t max_triangles = 40'000'000;
};

/// Parses the bytes of a mesh file. `name` is used in messages only. Polygons are fanned into
/// triangles (at most 64 corners a face; faces of one or two corners enclose nothing and are passed
/// over); a file without faces is a cloud. The order of vertices is the file's own for PLY, OBJ and
/// OFF; three per facet for STL (nothing is joined, normals are not taken over); the POSITION
/// accessors in node order for glTF, moved by the nodes' transforms. Normals come back at unit
/// length, or zero where they have no direction; colours from 0..1, 0..255 or 0..65535 as bytes,
/// cut off there; either only where every vertex has one. Coordinates are finite and at most 1e12.
/// Throws ReadError naming file, line or byte, and what to do, also for what follows the last
/// element. Call it through `read_mesh_sandboxed` for files from outside.
Mesh parse_mesh(std::span<const std::byte> bytes, MeshFormat format, std::string_view name,
                const MeshReadLimits& limits = {});

/// Recognises the format by content first, then by file extension; throws ReadError when neither
/// tells or when both disagree.
MeshFormat recognise_format(std::span<const std::byte> bytes, const std::filesystem::path& path);

}  // namespace regarment
