#pragma once

#include <string>
#include <vector>

#include "measure/garment_edges.h"

namespace regarment {

/// A garment's edges, some of them at another place where they may as well lie.
struct EdgePlaces {
  GarmentEdges edges;
  std::vector<std::string> moved;  // names of the edges that are not where they were found
  double weight = 0;               // 0..1, how probable by what the scan shows of edges
};

/// The edges as found, first, then the most probable others, at most `most` of them, each with a
/// weight of at least `least`; all weights add up to 1. Edges round the trunk move one at a time,
/// both cuffs together: two sleeves that end alike are more probable. A moved edge has the place
/// where it was found among its rivals.
std::vector<EdgePlaces> edge_places(const GarmentEdges& edges, std::size_t most, double least);

}  // namespace regarment
