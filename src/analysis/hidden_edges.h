#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "measure/observe.h"
#include "placement/body.h"

namespace regarment {

/// Where an edge lies that an outer garment hides.
struct HiddenEdge {
  double beyond = 0;              // m, further along the cloth than where it is cut off, > 0
  double standard_deviation = 0;  // m
};

/// The covered edges round the trunk, by name. A top edge bears the garment, so it lies between
/// hips and waist as such edges do; a hem that is tucked in lies as deep as it has to stay there.
std::map<std::string, HiddenEdge> hidden_edges(const GarmentEdges& edges, const Body& body);

/// A length that ends at a hidden edge.
struct ProbableLength {
  double value = 0;               // m, what shows of it and what is probably hidden
  double standard_deviation = 0;  // m
};

/// How long a path probably is that ends at hidden edges; nothing for one that is seen, of which
/// nothing shows, or that is no path.
std::optional<ProbableLength> probable_length(const ObservedLength& path,
                                              const std::map<std::string, HiddenEdge>& hidden);

/// What is known of a dimension that a hidden edge has a part in.
struct HiddenDimension {
  bool told = false;              // it lies on cloth that shows, though the place is a guess
  double standard_deviation = 0;  // m, from where the edge may lie; 0: nothing tells of it
  std::optional<double> value;    // m, where no fit knows better: what is probable
  double least = 0;               // m, what shows of it
};

/// One entry per dimension that an observation with a hidden edge gives. `dimensions`: what
/// the garment was found to have, m; `typical`: what garments of its kind have.
std::map<std::string, HiddenDimension> hidden_dimensions(
    const std::map<std::string, HiddenEdge>& hidden, const std::vector<ObservedLength>& observed,
    const Dimensions& dimensions, const Dimensions& typical);

}  // namespace regarment
