#pragma once

#include <string>
#include <vector>

#include "garment/pattern.h"
#include "geometry/mesh.h"
#include "synthetic/fabric.h"

namespace regarment {

/// A garment made and worn: its true flat dimensions, and where it lies.
struct WornGarment {
  std::string template_name;
  Dimensions dimensions;  // m, of the flat garment: the truth
  SheetFabric fabric;
  double band = 0.0;            // m, width of a strip of double thickness along the top edge (a
                                // skirt's waistband); 0: none
  Pattern pattern;              // flat, at `dimensions`
  std::vector<Vec3> particles;  // one per particle of the pattern: the middle of the cloth, body
                                // frame, m
};

/// A person and what they wear. Body frame: metres, +y up, +z where the person faces, +x to the
/// person's left, floor at y = 0.
struct DressedPerson {
  Mesh body;                          // undressed, closed, outward triangles
  std::vector<WornGarment> garments;  // outermost first
};

}  // namespace regarment
