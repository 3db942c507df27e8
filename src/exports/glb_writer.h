#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Puts a binary glTF 2.0 file (GLB) together: one buffer, tightly packed, little-endian. Each
/// method adds an array and returns the number of its accessor, for the document that names it.
/// Values that are not finite are not allowed in glTF; the caller leaves them out. The same calls
/// give the same bytes everywhere.
class GlbWriter {
 public:
  int positions(std::span<const Vec3> values);    // VEC3 float, with bounds; at least one
  int vectors(std::span<const Vec3> values);      // VEC3 float
  int coordinates(std::span<const Vec2> values);  // VEC2 float
  int scalars(std::span<const float> values);     // SCALAR float
  /// VEC4 normalized unsigned byte; sRGB in, linear out as glTF has it.
  int colours(std::span<const Colour> values);
  int indices(std::span<const std::uint32_t> values);  // SCALAR unsigned int, an element array

  /// The whole file. `document`: the rest of the glTF document as JSON text, without `buffers`,
  /// `bufferViews` and `accessors`.
  std::string bytes(std::string_view document) const;

 private:
  struct Accessor {
    const char* type;
    int component;  // of glTF: 5121, 5125, 5126
    std::size_t count, offset, size;
    bool is_index = false;
    std::vector<float> low = {}, high = {};
  };
  int add(Accessor accessor);
  int floats(const char* type, std::size_t count, const std::vector<float>& values);

  std::string data_;
  std::vector<Accessor> accessors_;
};

}  // namespace regarment
