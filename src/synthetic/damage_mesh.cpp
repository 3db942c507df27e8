#include "synthetic/damage_mesh.h"

#include <Eigen/Geometry>
#include <utility>

#include "synthetic/scanner_options.h"

namespace regarment {
namespace {

constexpr double kFin = 0.005;  // m, how far a fin stands off

class Damaging {
 public:
  Damaging(Random& random, SurfacedPerson& person)
      : random_(random), person_(person), mesh_(person.mesh), count_(mesh_.triangles.size()) {}

  void turn() {
    Triangle& t = any_triangle();
    std::swap(t[1], t[2]);
  }

  // The triangle's first corner gets a vertex of its own at the same place.
  void split() {
    Triangle& t = any_triangle();
    t[0] = copy_of(t[0]);
  }

  void add_fin() {
    const Triangle t = any_triangle();
    const Vec3& a = mesh_.positions[t[0]];
    const Vec3 normal = (mesh_.positions[t[1]] - a).cross(mesh_.positions[t[2]] - a).normalized();
    const Vec3 off = 0.5 * (a + mesh_.positions[t[1]]) + kFin * normal;
    const std::uint32_t fin = copy_of(t[0]);
    mesh_.positions[fin] = off;
    person_.labels[fin] = ScannedPerson::kOutlier;
    mesh_.triangles.push_back({t[0], t[1], fin});
  }

  void add_empty() {
    const Triangle t = any_triangle();
    if (random_.uniform() < 0.5)
      mesh_.triangles.push_back({t[0], t[1], t[1]});
    else
      mesh_.triangles.push_back({t[0], t[1], copy_of(t[0])});
  }

 private:
  // One of those that were there from the beginning.
  Triangle& any_triangle() {
    return mesh_
        .triangles[static_cast<std::size_t>(random_.uniform() * static_cast<double>(count_))];
  }

  std::uint32_t copy_of(std::uint32_t v) {
    mesh_.positions.push_back(Vec3(mesh_.positions[v]));
    if (!mesh_.colours.empty()) mesh_.colours.push_back(Colour(mesh_.colours[v]));
    person_.labels.push_back(std::uint8_t(person_.labels[v]));
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  Random& random_;
  SurfacedPerson& person_;
  Mesh& mesh_;
  std::size_t count_;
};

}  // namespace

void MeshDamageOptions::check() const {
  check_scanner_value("turned", turned, 0, 10000);
  check_scanner_value("split", split, 0, 10000);
  check_scanner_value("fins", fins, 0, 10000);
  check_scanner_value("empty", empty, 0, 10000);
}

void damage_mesh(const MeshDamageOptions& options, Random& random, SurfacedPerson& person) {
  options.check();
  if (person.mesh.triangles.empty()) return;
  Damaging damage(random, person);
  for (int i = 0; i < options.turned; ++i) damage.turn();
  for (int i = 0; i < options.split; ++i) damage.split();
  for (int i = 0; i < options.fins; ++i) damage.add_fin();
  for (int i = 0; i < options.empty; ++i) damage.add_empty();
}

}  // namespace regarment
