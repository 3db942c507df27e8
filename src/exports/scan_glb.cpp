#include "exports/scan_glb.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "exports/glb_writer.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPoints = 0, kTriangles = 4;  // modes of glTF

void check_sizes(const LabelledScan& scan) {
  const std::size_t n = scan.mesh.positions.size();
  if (n == 0) throw InvalidInput("a scan without vertices makes no glTF file");
  if (scan.labels.size() != n || scan.colours.size() != n ||
      (!scan.probability.empty() && scan.probability.size() != n)) {
    throw InvalidInput("a labelled scan needs one label, colour and probability per vertex");
  }
}

std::vector<std::uint32_t> shown_triangles(const Mesh& mesh) {
  std::vector<std::uint32_t> out;
  out.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const bool finite = std::all_of(t.begin(), t.end(),
                                    [&](std::uint32_t v) { return mesh.positions[v].allFinite(); });
    if (finite) out.insert(out.end(), t.begin(), t.end());
  }
  return out;
}

std::vector<std::uint32_t> shown_points(const Mesh& mesh) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].allFinite()) out.push_back(v);
  }
  return out;
}

int add_positions(const Mesh& mesh, bool all_finite, GlbWriter& glb) {
  if (all_finite) return glb.positions(mesh.positions);
  std::vector<Vec3> positions = mesh.positions;
  for (Vec3& p : positions) {
    if (!p.allFinite()) p = Vec3::Zero();
  }
  return glb.positions(positions);
}

Json matrix_json(const Eigen::Affine3d& transform) {
  const Eigen::Matrix4d& m = transform.matrix();
  return std::vector<double>(m.data(), m.data() + m.size());
}

}  // namespace

std::string scan_glb(const LabelledScan& scan) {
  check_sizes(scan);
  const Mesh& mesh = scan.mesh;
  const bool all_finite = std::all_of(mesh.positions.begin(), mesh.positions.end(),
                                      [](const Vec3& p) { return p.allFinite(); });
  GlbWriter glb;
  Json attributes = {{"POSITION", add_positions(mesh, all_finite, glb)},
                     {"COLOR_0", glb.colours(scan.colours)}};
  attributes["_LABEL"] = glb.scalars(std::vector<float>(scan.labels.begin(), scan.labels.end()));
  if (!scan.probability.empty()) attributes["_PROBABILITY"] = glb.scalars(scan.probability);
  Json primitive = {{"attributes", attributes}, {"material", 0}};
  const std::vector<std::uint32_t> shown =
      mesh.is_cloud() ? (all_finite ? std::vector<std::uint32_t>() : shown_points(mesh))
                      : shown_triangles(mesh);
  if (!shown.empty()) primitive["indices"] = glb.indices(shown);
  const bool as_points = mesh.is_cloud() || shown.empty();
  primitive["mode"] = as_points ? kPoints : kTriangles;
  const Json document = {
      {"asset", {{"version", "2.0"}, {"generator", "regarment"}}},
      {"scene", 0},
      {"scenes",
       {{{"nodes", {0}}, {"extras", {{"file_from_scene", matrix_json(scan.file_from_mesh)}}}}}},
      {"nodes", {{{"mesh", 0}, {"name", "scan"}}}},
      {"meshes", {{{"name", "scan"}, {"primitives", Json::array({primitive})}}}},
      {"materials",
       {{{"name", "labels"},
         {"doubleSided", true},
         {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}}}}}};
  return glb.bytes(document.dump());
}

}  // namespace regarment
