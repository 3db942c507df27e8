#pragma once

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <fstream>

#include <nlohmann/json.hpp>

#include "geometry/mesh_io.h"
#include "run_tool.h"
#include "support/folders.h"

// A GLB file as others read it.

namespace regarment {

inline Mesh read_with_our_reader(const std::string& bytes, MeshFormat format) {
  return parse_mesh(std::as_bytes(std::span(bytes)), format, "made");
}

inline const aiScene* read_with_assimp(Assimp::Importer& importer, const std::string& bytes,
                                       const char* hint) {
  return importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint);
}

/// The report of glTF-Validator; null where it or node is not installed.
inline nlohmann::json validated(const std::string& glb) {
  const TemporaryFolder home;
  const std::string file = home.path() / "made.glb";
  std::ofstream(file, std::ios::binary) << glb;
  if (!std::filesystem::exists(beside_tests("node_modules/gltf-validator"))) return nullptr;
  const auto run = run_tool({"node", beside_tests("validate_glb.js"), file});
  if (!run) return nullptr;
  EXPECT_EQ(run->status, 0) << run->text;
  return nlohmann::json::parse(run->text, nullptr, false);
}

inline constexpr const char* kNoValidator =
    "gltf-validator is not installed: 'npm ci' in tests/exports";

/// The document of a GLB file, and its numbers: the bytes of an accessor.
inline nlohmann::json document_of(const std::string& glb) {
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, sizeof size);
  return nlohmann::json::parse(glb.substr(20, size));
}

template <typename T>
std::vector<T> numbers_of(const std::string& glb, int accessor) {
  const nlohmann::json document = document_of(glb);
  std::uint32_t json_size = 0;
  std::memcpy(&json_size, glb.data() + 12, sizeof json_size);
  const nlohmann::json& view =
      document["bufferViews"][document["accessors"][accessor]["bufferView"].get<int>()];
  const std::size_t offset = 28 + json_size + view["byteOffset"].get<std::size_t>();
  std::vector<T> out(view["byteLength"].get<std::size_t>() / sizeof(T));
  std::memcpy(out.data(), glb.data() + offset, out.size() * sizeof(T));
  return out;
}

}  // namespace regarment
