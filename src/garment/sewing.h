#pragma once

#include <array>
#include <vector>

#include "garment/pattern.h"
#include "garment/shape_mesh.h"
#include "garment/template_data.h"

namespace regarment {

/// Lays out the panels of a template from the meshes of its shapes, sews the seams and finds the
/// loops of free edge. `flat` stays empty (place_vertices fills it). Throws InvalidInput when the
/// sewn panels are no surface: an edge shared by three triangles, two free edges meeting, a free
/// edge that is not exactly one closed loop.
Pattern sew(const TemplateData& data, const std::vector<ShapeMesh>& shapes);

/// Index of the first coarse point of each panel's half among all coarse points: [panel][half].
std::vector<std::array<int, 2>> coarse_offsets(const TemplateData& data);

}  // namespace regarment
