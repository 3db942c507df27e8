#pragma once

#include <string>
#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// A garment on the body, ready for animation. `draped`: one position per pattern vertex, metres,
/// y up; vertices sewn together lie in one place. `pattern` is flat at the garment's size.
struct DressedGarment {
  std::string name;  // "skirt"
  const Pattern& pattern;
  const std::vector<Vec3>& draped;
};

/// Mass of cloth assumed in the exported masses, kg/m^2: that of the simulated cloth
/// (drape/cloth.h).
inline constexpr double kExportDensity = 0.2;

/// The garment as a GLB file: one mesh, one primitive and material per panel, all on shared arrays
/// POSITION, NORMAL, TEXCOORD_0 (flat panel coordinates s, t in metres: one unit of texture is one
/// metre of cloth, and the distance of two neighbours in it their rest length), _PARTICLE (vertices
/// sewn together share one) and _MASS (kg, the vertex's own share; a particle has its vertices'
/// sum). The mesh's extras hold `cloth`: particle count, density, and the accessors of the springs:
/// pairs of particles and rest lengths in metres. Throws InvalidInput when the sizes differ.
std::string garment_glb(const DressedGarment& garment);

}  // namespace regarment
