#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <optional>

#include "base/one_line.h"
#include "geometry/gltf_counts.h"
#include "geometry/mesh_readers.h"

namespace regarment {
namespace {

// What assimp gets to see of the file system: nothing. Buffers in other files stay shut.
class NoFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

// Leaves one importer of assimp's forty: the others never see a byte of the file.
void keep_only(Assimp::Importer& importer, std::string_view wanted) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    if (importer.GetImporterInfo(i)->mName != wanted) others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* other : others) {
    importer.UnregisterLoader(other);
    delete other;  // unregistering hands it over
  }
}

// Adds the meshes of a scene to a builder; each is a part of the file, counted from 1.
class SceneReader {
 public:
  SceneReader(const aiScene& scene, MeshBuilder& builder) : scene_(scene), builder_(builder) {
    has_colours_ = true;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      has_colours_ = has_colours_ && scene.mMeshes[i]->HasVertexColors(0);
    }
  }

  // Node depth is bounded by the importers, which walk it recursively themselves.
  void add_node(const aiNode& node, const aiMatrix4x4& scene_from_parent) {
    const aiMatrix4x4 scene_from_node = scene_from_parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], scene_from_node);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(*node.mChildren[i], scene_from_node);
  }

 private:
  void add_mesh(const aiMesh& mesh, const aiMatrix4x4& scene_from_mesh);
  void add_face(const aiFace& face, const aiMesh& mesh, std::size_t first, bool mirrored);

  const aiScene& scene_;
  MeshBuilder& builder_;
  bool has_colours_ = false;
  Place place_{Place::Unit::Part, 0};
};

void SceneReader::add_mesh(const aiMesh& mesh, const aiMatrix4x4& scene_from_mesh) {
  ++place_.at;
  const std::size_t first = builder_.mesh().positions.size();
  builder_.check_vertex_count(first + mesh.mNumVertices, place_);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D p = scene_from_mesh * mesh.mVertices[i];
    builder_.add_vertex(static_cast<double>(p.x), static_cast<double>(p.y),
                        static_cast<double>(p.z), place_);
    if (!has_colours_) continue;
    const aiColor4D& colour = mesh.mColors[0][i];
    builder_.add_colour(static_cast<double>(colour.r), static_cast<double>(colour.g),
                        static_cast<double>(colour.b), 255.0);
  }
  const bool mirrored = scene_from_mesh.Determinant() < 0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) add_face(mesh.mFaces[i], mesh, first, mirrored);
}

void SceneReader::add_face(const aiFace& face, const aiMesh& mesh, std::size_t first,
                           bool mirrored) {
  std::vector<std::int64_t> corners;
  for (unsigned i = 0; i < face.mNumIndices; ++i) {
    const unsigned corner = face.mIndices[mirrored ? face.mNumIndices - 1 - i : i];
    if (corner >= mesh.mNumVertices) {
      builder_.fail(place_, "a face names vertex " + std::to_string(corner) + ", the part has " +
                                std::to_string(mesh.mNumVertices) + "; export the file again");
    }
    corners.push_back(static_cast<std::int64_t>(first) + corner);
  }
  builder_.add_face(corners, place_);
}

// assimp leaves out faces whose indices point nowhere, and says nothing.
void check_complete(std::string_view file, const MeshBuilder& builder, const Mesh& mesh) {
  const Place start{Place::Unit::Byte, 0};
  const std::optional<GltfCounts> promised = count_gltf(file);
  if (!promised) builder.fail(start, "its JSON is not what glTF 2.0 asks for; export it again");
  if (promised->vertices != mesh.positions.size() || promised->triangles != mesh.triangles.size()) {
    builder.fail(start, "it promises " + std::to_string(promised->vertices) + " vertices and " +
                            std::to_string(promised->triangles) + " triangles, of which " +
                            std::to_string(mesh.positions.size()) + " and " +
                            std::to_string(mesh.triangles.size()) + " are sound; export it again");
  }
}

}  // namespace

void read_gltf(std::string_view file, MeshBuilder& builder) {
  // assimp reads such meshes as zeros.
  for (const char* packed : {"\"KHR_draco_mesh_compression\"", "\"EXT_meshopt_compression\""}) {
    if (file.find(packed) == std::string_view::npos) continue;
    builder.fail(
        {Place::Unit::Byte, file.find(packed)},
        "its geometry is compressed (" + std::string(packed) + "); save it without compression");
  }
  Assimp::Importer importer;
  keep_only(importer, "glTF2 Importer");
  importer.SetIOHandler(new NoFiles);  // the importer owns it
  const char* const hint = file.starts_with("glTF") ? "glb" : "gltf";
  const aiScene* scene = importer.ReadFileFromMemory(file.data(), file.size(), 0, hint);
  const Place start{Place::Unit::Byte, 0};
  if (scene == nullptr) {
    const std::string_view words = importer.GetErrorString();
    if (words.find("could not open referenced file") != std::string_view::npos) {
      builder.fail(start, "it refers to another file, which is never opened; save it as GLB");
    }
    builder.fail(start, "it cannot be read: " + one_line(words) + "; export it again");
  }
  if (scene->mRootNode != nullptr) {
    SceneReader(*scene, builder).add_node(*scene->mRootNode, aiMatrix4x4());
  }
  check_complete(file, builder, builder.mesh());
}

}  // namespace regarment
