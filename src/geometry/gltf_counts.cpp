#include "geometry/gltf_counts.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

namespace regarment {
namespace {

using Json = nlohmann::json;

// A GLB file holds its JSON in the first chunk, behind 12 bytes of header and 8 of its own.
std::string_view json_text(std::string_view file) {
  constexpr std::size_t kStart = 20;
  if (!file.starts_with("glTF")) return file;
  if (file.size() < kStart) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + 12, sizeof length);
  return file.substr(kStart, length);
}

// Triangles that so many corners make in each of glTF's modes.
std::uint64_t triangles_of(unsigned mode, std::uint64_t corners) {
  constexpr unsigned kList = 4, kStrip = 5, kFan = 6;
  if (mode == kList) return corners / 3;
  return (mode == kStrip || mode == kFan) && corners > 2 ? corners - 2 : 0;
}

void add_mesh(const Json& root, const Json& mesh, GltfCounts& counts) {
  for (const Json& primitive : mesh.at("primitives")) {
    const Json& attributes = primitive.at("attributes");
    if (!attributes.contains("POSITION")) continue;
    const Json& accessors = root.at("accessors");
    const auto entries = [&](const Json& index) {
      return accessors.at(index.get<std::size_t>()).at("count").get<std::uint64_t>();
    };
    const std::uint64_t vertices = entries(attributes.at("POSITION"));
    const std::uint64_t corners =
        primitive.contains("indices") ? entries(primitive.at("indices")) : vertices;
    counts.vertices += vertices;
    counts.triangles += triangles_of(primitive.value("mode", 4U), corners);
  }
}

GltfCounts count_scene(const Json& root) {
  GltfCounts counts;
  const Json& scene = root.at("scenes").at(root.value("scene", std::size_t{0}));
  std::vector<std::size_t> open = scene.value("nodes", std::vector<std::size_t>());
  // Each node has one parent, so a walk that is longer than the list of nodes runs in a ring.
  for (std::size_t left = root.value("nodes", Json::array()).size(); !open.empty(); --left) {
    if (left == 0) return {};
    const Json& node = root.at("nodes").at(open.back());
    open.pop_back();
    if (node.contains("mesh")) {
      add_mesh(root, root.at("meshes").at(node.at("mesh").get<std::size_t>()), counts);
    }
    for (const Json& child : node.value("children", Json::array())) {
      open.push_back(child.get<std::size_t>());
    }
  }
  return counts;
}

}  // namespace

std::optional<GltfCounts> count_gltf(std::string_view file) try {
  return count_scene(Json::parse(json_text(file)));
} catch (const Json::exception&) {
  return std::nullopt;
}

}  // namespace regarment
