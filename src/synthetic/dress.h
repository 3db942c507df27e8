#pragma once

#include <vector>

#include "base/progress.h"
#include "synthetic/dressed_person.h"

namespace regarment {

/// A garment somebody is to wear.
struct GarmentWish {
  std::string template_name;
  Dimensions dimensions;  // m
  SheetFabric fabric;
  double band = 0.0;  // m, see WornGarment::band
  // m above the floor where the top edge of a garment that hangs from the waist is put on; not
  // looked at where one has sleeves and hangs from the shoulders.
  double top_height = 0.0;
};

struct DressOptions {
  // m, edge of the cloth's triangles at rest, 0.006 .. 0.04. Smaller shows finer folds; time grows
  // with its inverse cube.
  double edge_length = 0.012;
  double longest = 2.5;  // s of simulated time fine cloth is given to come to rest

  void check() const;  // throws InvalidInput naming the field and its value
};

/// How one garment came to lie.
struct DressReport {
  bool came_to_rest = false;
  double fastest = 0.0;    // m/s, 99th percentile of the speeds at the end
  double deepest = 0.0;    // m, furthest that a sample of the cloth lies inside the body; 0: none
  double simulated = 0.0;  // s
};

/// A person dressed, and how well it went; the caller decides what to keep.
struct Dressing {
  DressedPerson person;
  std::vector<DressReport> reports;  // one per garment, outermost first
};

/// Sews the garments, puts them on a body innermost first and lets them come to rest under gravity
/// with contact and friction against the body, the garments below and themselves.
///
/// `poses` are one body (same triangles) as it moves while it dresses: the garments are put on in
/// the first, best with the arms stretched sideways and about 28 degrees down as a T-shirt's
/// sleeves are cut; the body passes through the others at even times and is worn, and returned, as
/// the last. A single pose does not move. Each is closed, with outward triangles and the floor at y
/// = 0 (see DressedPerson).
///
/// Cloth is a continuum of triangles with separate stiffness along, across and in shear, moved by
/// implicit steps of a quasi-Newton method; it shares nothing with the cloth of `drape`. Same bytes
/// for same input. Throws InvalidInput for dimensions that make no garment, bodies that are none or
/// differ in their triangles, Stopped when progress says so.
Dressing dress_person(const std::vector<Mesh>& poses, const std::vector<GarmentWish>& garments,
                      const DressOptions& options = {}, const Progress& progress = {});

}  // namespace regarment
