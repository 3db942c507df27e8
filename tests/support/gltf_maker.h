#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace regarment::test {

/// Base64 of RFC 4648.
inline std::string base64(std::string_view bytes) {
  static constexpr char kLetters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool padding = i + k > bytes.size();
      text += padding ? '=' : kLetters[group >> (18 - 6 * k) & 63U];
    }
  }
  return text;
}

/// Puts a glTF 2.0 file together from meshes of one primitive each.
class GltfMaker {
 public:
  /// Returns the index of the mesh. Without indices it is a cloud of points.
  std::size_t mesh(const std::vector<std::array<float, 3>>& positions,
                   const std::vector<std::uint16_t>& indices) {
    const std::string place =
        "\"componentType\":5126,\"type\":\"VEC3\",\"min\":[-99,-99,-99],\"max\":[99,99,99]";
    const std::size_t accessor = add(positions.data(), positions.size(), place);
    std::string primitive = "{\"attributes\":{\"POSITION\":" + std::to_string(accessor) + "}";
    if (indices.empty()) {
      primitive += ",\"mode\":0";
    } else {
      primitive +=
          ",\"indices\":" + std::to_string(add(indices.data(), indices.size(),
                                               "\"componentType\":5123,\"type\":\"SCALAR\""));
    }
    append(meshes_, "{\"primitives\":[" + primitive + "}]}");
    return mesh_count_++;
  }
  /// Adds a node as JSON members, as in `"mesh":0,"translation":[1,0,0]`.
  GltfMaker& node(const std::string& members) {
    append(nodes_, "{" + members + "}");
    return *this;
  }

  /// The JSON text; `roots` are the scene's nodes, `uri` stands for the buffer, "" for none.
  std::string json(const std::string& roots, const std::string& uri) const {
    const std::string link = uri.empty() ? "" : ",\"uri\":\"" + uri + "\"";
    return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[" + roots +
           "]}],\"nodes\":[" + nodes_ + "],\"meshes\":[" + meshes_ + "],\"accessors\":[" +
           accessors_ + "],\"bufferViews\":[" + views_ +
           "],\"buffers\":[{\"byteLength\":" + std::to_string(buffer_.size()) + link + "}]}";
  }
  std::string gltf(const std::string& roots) const {
    return json(roots, "data:application/octet-stream;base64," + base64(buffer_));
  }
  std::string glb(const std::string& roots) const {
    const std::string text = padded(json(roots, ""), ' ');
    const std::string data = padded(buffer_, '\0');
    std::string file = "glTF";
    for (const std::size_t word : {std::size_t{2}, 28 + text.size() + data.size(), text.size()}) {
      put(file, word);
    }
    file += "JSON" + text;
    put(file, data.size());
    return file + std::string("BIN\0", 4) + data;
  }

 private:
  static void append(std::string& list, const std::string& entry) {
    list += (list.empty() ? "" : ",") + entry;
  }
  static void put(std::string& file, std::size_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8)
      file += static_cast<char>(word >> shift & 255U);
  }
  static std::string padded(std::string text, char with) {
    while (text.size() % 4 != 0) text += with;
    return text;
  }
  template <class Value>
  std::size_t add(const Value* values, std::size_t count, const std::string& members) {
    const std::size_t offset = buffer_.size();
    buffer_.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
    append(views_, "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
                       ",\"byteLength\":" + std::to_string(buffer_.size() - offset) + "}");
    append(accessors_, "{\"bufferView\":" + std::to_string(accessor_count_) +
                           ",\"count\":" + std::to_string(count) + "," + members + "}");
    buffer_ = padded(std::move(buffer_), '\0');
    return accessor_count_++;
  }

  std::string nodes_, meshes_, accessors_, views_, buffer_;
  std::size_t mesh_count_ = 0, accessor_count_ = 0;
};

}  // namespace regarment::test
