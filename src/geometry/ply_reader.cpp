#include <algorithm>
#include <array>
#include <bit>

#include "base/one_line.h"
#include "geometry/mesh_readers.h"
#include "geometry/ply_header.h"
#include "geometry/ply_rows.h"

namespace regarment {
namespace {

// What a vertex property means to us; positions in the array of a row's values.
enum Role : std::uint8_t { kX, kY, kZ, kNx, kNy, kNz, kRed, kGreen, kBlue, kRoles };

constexpr std::array<std::string_view, kRoles> kRoleNames{"x",  "y",   "z",     "nx",  "ny",
                                                          "nz", "red", "green", "blue"};

struct VertexPlan {
  std::vector<std::uint8_t> roles;     // one per property, kRoles: passed over
  std::array<double, kRoles> scale{};  // 0 where the file has no such property
  bool has(Role first) const {
    return scale[first] > 0 && scale[first + 1] > 0 && scale[first + 2] > 0;
  }
};

// Colours become 0..255: floating-point ones run from 0 to 1, 16-bit ones from 0 to 65535.
double colour_scale(PlyScalar type) {
  if (is_floating(type)) return 255.0;
  return type == PlyScalar::Uint16 ? 1.0 / 257.0 : 1.0;
}

std::uint8_t role_of(std::string_view name) {
  const auto* const found = std::find(kRoleNames.begin(), kRoleNames.end(), name);
  return static_cast<std::uint8_t>(found - kRoleNames.begin());
}

VertexPlan plan_vertices(const PlyElement& element, const MeshBuilder& builder) {
  VertexPlan plan;
  plan.roles.assign(element.properties.size(), kRoles);
  // A plain name wins over its older spelling "diffuse_red".
  for (const bool older : {false, true}) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      std::string_view name = property.name;
      if (older != name.starts_with("diffuse_")) continue;
      if (older) name.remove_prefix(std::string_view("diffuse_").size());
      const std::uint8_t role = role_of(name);
      if (role == kRoles || (older && role < kRed) || plan.scale[role] > 0) continue;
      if (property.is_list) {
        if (role > kZ) continue;
        builder.fail({Place::Unit::Line, element.line}, "the vertex property '" + property.name +
                                                            "' is a list; export the file again");
      }
      plan.roles[i] = role;
      plan.scale[role] = role < kRed ? 1.0 : colour_scale(property.type);
    }
  }
  for (const Role role : {kX, kY, kZ}) {
    if (plan.scale[role] > 0) continue;
    builder.fail({Place::Unit::Line, element.line}, "the vertices have no property '" +
                                                        std::string(kRoleNames[role]) +
                                                        "'; export the file again");
  }
  return plan;
}

template <class Rows>
std::uint64_t list_length(Rows& rows, const PlyProperty& list, const MeshBuilder& builder) {
  const std::int64_t length = rows.index(list.count_type);
  if (length < 0) {
    builder.fail(rows.place(), "a list has the negative length " + std::to_string(length) +
                                   "; export the file again");
  }
  return static_cast<std::uint64_t>(length);
}

template <class Rows>
void skip_property(Rows& rows, const PlyProperty& property, const MeshBuilder& builder) {
  if (!property.is_list) return rows.skip(property.type);
  const std::uint64_t length = list_length(rows, property, builder);
  rows.skip_many(property.type, length);
}

template <class Rows>
void read_vertices(Rows& rows, const PlyElement& element, MeshBuilder& builder) {
  const VertexPlan plan = plan_vertices(element, builder);
  const bool has_normals = plan.has(kNx);
  const bool has_colours = plan.has(kRed);
  Mesh& mesh = builder.mesh();
  mesh.positions.reserve(element.count);
  if (has_normals) mesh.normals.reserve(element.count);
  if (has_colours) mesh.colours.reserve(element.count);
  std::array<double, kRoles> v{};
  for (std::uint64_t row = 0; row < element.count; ++row) {
    rows.begin_row(element, row);
    for (std::size_t i = 0; i < plan.roles.size(); ++i) {
      const std::uint8_t role = plan.roles[i];
      if (role == kRoles) {
        skip_property(rows, element.properties[i], builder);
      } else {
        v[role] = rows.scalar(element.properties[i].type) * plan.scale[role];
      }
    }
    rows.end_row();
    builder.add_vertex(v[kX], v[kY], v[kZ], rows.place());
    if (has_normals) builder.add_normal(v[kNx], v[kNy], v[kNz]);
    if (has_colours) builder.add_colour(v[kRed], v[kGreen], v[kBlue]);
  }
}

bool is_corner_list(const PlyProperty& property) {
  return property.is_list && !is_floating(property.type) &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

template <class Rows>
void read_faces(Rows& rows, const PlyElement& element, MeshBuilder& builder) {
  const auto corners =
      std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
  if (corners == element.properties.end()) {
    builder.fail({Place::Unit::Line, element.line},
                 "the faces have no list of whole numbers 'vertex_indices'; export the file again");
  }
  builder.mesh().triangles.reserve(element.count);
  std::array<std::int64_t, MeshBuilder::kMostCorners> face{};
  for (std::uint64_t row = 0; row < element.count; ++row) {
    rows.begin_row(element, row);
    std::uint64_t length = 0;
    for (auto property = element.properties.begin(); property != element.properties.end();
         ++property) {
      if (property != corners) {
        skip_property(rows, *property, builder);
        continue;
      }
      length = list_length(rows, *property, builder);
      if (length > face.size()) builder.refuse_corners(length, rows.place());
      for (std::size_t i = 0; i < length; ++i) face[i] = rows.index(property->type);
    }
    rows.end_row();
    builder.add_face({face.data(), length}, rows.place());
  }
}

template <class Rows>
void read_body(Rows rows, const PlyHeader& header, MeshBuilder& builder) {
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    rows.check_room(element);
    if (element.name == "vertex") {
      read_vertices(rows, element, builder);
    } else if (element.name == "face") {
      read_faces(rows, element, builder);
    } else {
      for (std::uint64_t row = 0; row < element.count; ++row) {
        rows.begin_row(element, row);
        for (const PlyProperty& property : element.properties) {
          skip_property(rows, property, builder);
        }
        rows.end_row();
      }
    }
  }
  rows.check_end();
}

}  // namespace

void read_ply(std::string_view file, MeshBuilder& builder) {
  const PlyHeader header = parse_ply_header(file, builder);
  constexpr bool kLittle = std::endian::native == std::endian::little;
  switch (header.encoding) {
    case PlyEncoding::Ascii:
      return read_body(AsciiPlyRows(file, header, builder), header, builder);
    case PlyEncoding::LittleEndian:
      return read_body(BinaryPlyRows<!kLittle>(file, header, builder), header, builder);
    case PlyEncoding::BigEndian:
      return read_body(BinaryPlyRows<kLittle>(file, header, builder), header, builder);
  }
}

}  // namespace regarment
