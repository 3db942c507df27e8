// Any bytes as a mesh file: ReadError, or a mesh that holds what mesh.h promises.
#include <cmath>
#include <cstdlib>
#include <span>

#include "base/error.h"
#include "geometry/mesh_io.h"

namespace {

using namespace regarment;

void require(bool right) {
  if (!right) std::abort();
}

void check(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  require(n > 0);
  require(mesh.normals.empty() || mesh.normals.size() == n);
  require(mesh.colours.empty() || mesh.colours.size() == n);
  for (const Vec3& p : mesh.positions) require(p.allFinite());
  for (const Vec3& normal : mesh.normals) {
    const double length = normal.norm();
    require(length == 0.0 || std::abs(length - 1.0) < 1e-9);
  }
  for (const Triangle& t : mesh.triangles) require(t[0] < n && t[1] < n && t[2] < n);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(parse_mesh(std::as_bytes(std::span(data, size)), MeshFormat::REGARMENT_FORMAT, "input",
                     {.max_vertices = 100'000, .max_triangles = 100'000}));
  } catch (const ReadError&) {
  }
  return 0;
}
