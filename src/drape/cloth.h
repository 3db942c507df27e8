#pragma once

#include <array>
#include <vector>

#include "garment/pattern.h"
#include "garment/springs.h"

namespace regarment {

/// Two triangles that share a side, for bending: particles 0 and 1 are the corners opposite to the
/// side, 2 and 3 its ends, in the order of Bridson et al. 2003, Fig. 1, so that the normals of
/// (0, 2, 3) and (1, 3, 2) both point outwards.
struct BendingElement {
  std::array<int, 4> particles{};
  std::array<int, 2> triangles{};        // the one with corner 0, the one with corner 1
  int spring = 0;                        // the shared side
  double rest_side = 0;                  // its flat length |E|, m, > 0
  std::array<double, 2> rest_normals{};  // |N1|, |N2|: twice the flat areas, m^2, > 0
};

/// The sewn garment as particles and springs [Hasler et al. 2007, sec. 3.2]. Body frame, metres,
/// kilograms, seconds. Seams are closed: vertices of the pattern that are sewn together are one
/// particle.
struct Cloth {
  std::vector<Vec3> positions;          // n
  std::vector<Vec3> velocities;         // n, m/s
  std::vector<double> masses;           // n, kg, > 0
  std::vector<Triangle> triangles;      // over particles, counter-clockwise seen from outside
  std::vector<Spring> springs;          // each once, sorted
  std::vector<BendingElement> bending;  // each inner side of the triangles once

  std::size_t size() const { return positions.size(); }

  /// Throws InvalidInput, naming what and where, for cloth without particles, with numbers that are
  /// not finite or not positive where they must be, or with parts that do not match.
  void check() const;
};

/// A placed pattern as cloth at rest (velocities zero). `placed`: one position per pattern vertex,
/// those of one particle equal; `area_density` kg/m^2, > 0. Throws InvalidInput when they do not
/// match.
Cloth make_cloth(const Pattern& pattern, const std::vector<Vec3>& placed,
                 double area_density = 0.2);

/// Takes rest lengths, areas and masses from the pattern again, after move_pattern; positions stay
/// where they are [sec. 3.1]. Same topology, else InvalidInput.
void update_cloth(const Pattern& pattern, Cloth& cloth, double area_density = 0.2);

/// Positions of the particles, one per pattern vertex.
std::vector<Vec3> at_vertices(const Pattern& pattern, const std::vector<Vec3>& particles);

/// Area-weighted outward normals of the particles, unit; zero where all triangles at one have none.
std::vector<Vec3> particle_normals(const Cloth& cloth);

/// Mean over the springs of length over rest length, each once: E_stretch of sec. 3.3; 1 without
/// springs.
double mean_stretch(const Cloth& cloth);

}  // namespace regarment
