#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/analysis.h"

namespace regarment {

/// Adds what other programs read of a result: segmented.ply and .glb, and per garment I
/// garment-I.ply, .glb and .obj, pattern-I.json, .svg, .pdf, .dxf and .val. PLY files are in the
/// scan file's own frame and unit, GLB and OBJ files in metres, y up. `templates` are those of the
/// garments, in their order.
void add_exports(const Analysis& analysis, const std::vector<GarmentTemplate>& templates,
                 std::map<std::string, std::string>& files);

/// Positions in the scan file's own frame and unit.
std::vector<Vec3> in_file(const Scan& scan, const std::vector<Vec3>& p_in_body);

}  // namespace regarment
