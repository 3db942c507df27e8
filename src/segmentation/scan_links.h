#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scan/scan.h"
#include "segmentation/minimum_cut.h"

namespace regarment {

/// Which vertices of a scan lie side by side, and how readily a border runs between them: the edges
/// of a mesh, once for each triangle that has them, or each point of a cloud with its six nearest.
/// The cost is 1/2 on a smooth surface, so that two neighbours are usually worth 1, and falls to a
/// tenth of that at a crease or a step, where cloth ends on skin: by the angle between the normals,
/// and by how far the way from one to the other leaves the surface. `wanted`, one entry per vertex:
/// links of no such vertex are left out (of a cloud, those found from such a point are returned).
/// Outliers have no links. The order is given by the scan alone. Throws InvalidInput when there is
/// not one mark and one normal per vertex.
std::vector<CutLink> scan_links(const Scan& scan, std::span<const std::uint8_t> wanted);

}  // namespace regarment
