#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_builder.h"

namespace regarment {

enum class PlyScalar { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of one scalar in a binary file.
constexpr std::size_t size_of(PlyScalar scalar) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(scalar)];
}
constexpr bool is_floating(PlyScalar scalar) { return scalar >= PlyScalar::Float32; }

struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::Float32;
  bool is_list = false;
  PlyScalar count_type = PlyScalar::Uint8;  // of a list's length, an integer type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::size_t line = 0;  // of the header that declares it
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;  // in file order; exactly one is "vertex", at most one "face"
  std::size_t lines = 0;             // of the header, `end_header` included
  std::size_t bytes = 0;             // likewise; the body begins here
};

/// Reads a PLY header of at most 64 KiB. Complaints go through `builder` and name the line.
/// Element counts are as declared: whether the body can hold them is for the body to say.
PlyHeader parse_ply_header(std::string_view file, const MeshBuilder& builder);

}  // namespace regarment
