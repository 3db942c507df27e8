#pragma once

#include <cstdint>

#include "geometry/mesh.h"

namespace regarment::test {

/// A person put together from rounded cones whose pose and proportions are known: metres, +y up,
/// facing +z, left hand at +x, soles at y = 0. About 1.75 m tall.
struct PersonShape {
  double arm_angle =
      -50;  // degrees of the arms from the horizontal: -80 hang down, 0 T-pose, 80 raised
  double girth = 1.0;          // factor on all radii but the head's
  double head = 1.0;           // factor on the head: 2 makes a small child
  double stride = 0.0;         // m between the feet, front to back
  double skirt_hem = -1.0;     // height of a skirt's hem, m; below 0: no skirt
  double skirt_radius = 0.25;  // of the hem, m
  bool has_head = true, has_feet = true;
};

/// Its surface: one closed sheet per part, counter-clockwise seen from outside, triangles about
/// `edge` long. Parts overlap, as parts of modelled figures do.
Mesh made_person(const PersonShape& shape = {}, double edge = 0.03);

/// Points spread evenly at random over what of it can be seen from outside, about `count` of them,
/// each moved along the normal by a normal variate of `noise` metres. `normals` are the true ones.
Mesh made_cloud(const PersonShape& shape, std::size_t count, double noise = 0.0,
                std::uint32_t seed = 1);

/// Area of what can be seen from outside, m^2 (to about 1 %).
double seen_area(const PersonShape& shape);

/// A box of the given edges, its lower face at y = 0, with triangles about `edge` long.
Mesh made_box(const Vec3& size, double edge = 0.05);

/// A sphere.
Mesh made_sphere(double radius, const Vec3& centre = Vec3::Zero());

/// `mesh` with another one beside it.
void append(Mesh& mesh, const Mesh& other);

/// `mesh` turned, scaled and shifted.
Mesh moved(Mesh mesh, const Eigen::Matrix3d& turn, double scale = 1.0,
           const Vec3& shift = Vec3::Zero());

/// The mesh's vertices alone.
Mesh cloud_of(Mesh mesh);

}  // namespace regarment::test
