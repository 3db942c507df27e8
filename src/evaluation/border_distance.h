#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Pairs of vertices that lie next to each other: the edges of a mesh, or, for a cloud, each point
/// and its six nearest. Each pair once, smaller index first, sorted. Positions must be finite.
std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours(const Mesh& mesh);

/// How far the border between labels lies from the true one, in the unit of the positions.
///
/// The border is the set of points halfway between two neighbours with different labels. Pairs with
/// a vertex whose true label is 255 belong to neither border. The distance is the mean over both
/// borders' own means of the distance from each of their points to the nearest point of the other
/// border. Nothing when either border is empty. Labels have one entry per vertex (InvalidInput).
std::optional<double> border_distance(const Mesh& mesh, const std::vector<std::uint8_t>& labels,
                                      const std::vector<std::uint8_t>& truth);

}  // namespace regarment
