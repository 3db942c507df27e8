#pragma once

#include <Eigen/Geometry>
#include <span>
#include <string>

#include "geometry/mesh.h"

namespace regarment {

/// What a labelled scan is made of: one entry per vertex each. `mesh` in metres, y up, facing +z,
/// as glTF has it; `file_from_mesh` leads back to the scan file's own frame and unit.
struct LabelledScan {
  const Mesh& mesh;
  std::span<const std::uint8_t> labels;  // 0 person, i = i-th garment
  std::span<const float> probability;    // of the label, 0..1; or empty
  std::span<const Colour> colours;       // to show the labels, sRGB
  Eigen::Affine3d file_from_mesh = Eigen::Affine3d::Identity();
};

/// The scan as a GLB file: vertices in the order of the mesh, with COLOR_0, _LABEL and, where it is
/// known, _PROBABILITY (floats); triangles, or points for a cloud. A vertex that is not finite
/// keeps its place at the origin but is not drawn, and neither are triangles at it. The scene's
/// extras hold `file_from_scene`, a column-major 4 x 4 matrix. Throws InvalidInput when the arrays'
/// sizes differ from the mesh's or it has no vertex.
std::string scan_glb(const LabelledScan& scan);

}  // namespace regarment
