#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace regarment {

/// How much geometry the scene of a glTF or GLB file describes.
struct GltfCounts {
  std::uint64_t vertices = 0;   // entries of the POSITION accessors, once per node and primitive
  std::uint64_t triangles = 0;  // of triangle lists, strips and fans; points and lines have none
};

/// Counts them from the JSON alone: the oracle for what an importer returns. Nothing when the JSON
/// is not what glTF 2.0 asks for.
std::optional<GltfCounts> count_gltf(std::string_view file);

}  // namespace regarment
