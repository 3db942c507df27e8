#pragma once

#include "base/random.h"
#include "synthetic/reconstruct.h"

namespace regarment {

/// What programs that write meshes get wrong. Numbers are of triangles or vertices, 0 .. 10000.
struct MeshDamageOptions {
  int turned = 0;  // triangles seen from the wrong side
  int split = 0;   // corners of triangles with a vertex of their own, where another stands already
  int fins = 0;    // triangles too many on an edge, with a vertex of their own (label 255)
  int empty = 0;   // triangles without area: two of their corners are one vertex or place

  void check() const;  // throws InvalidInput naming the field and its value
};

/// Damages a mesh; the places are drawn at random. New vertices stand at the end. The surface as a
/// set of points stays, but for the fins. A mesh without triangles stays as it is.
void damage_mesh(const MeshDamageOptions& options, Random& random, SurfacedPerson& person);

}  // namespace regarment
