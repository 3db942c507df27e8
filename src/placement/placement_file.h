#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "placement/body.h"

namespace regarment {

/// What a person says about where the body's parts and the garment's edges are. Heights above the
/// floor, m. Empty maps leave everything to the program.
struct PlacementOverrides {
  std::map<std::string, double>
      landmarks;  // "crotch", "left_armpit", "right_armpit", "shoulder", "neck"
  std::map<std::string, double> edges;  // name of an edge, but of a neckline -> its height
};

/// Reads a placement file: {"format": "regarment.placement/1", "landmarks_cm": {"neck": 143.5},
/// "edges_cm": {"waist": 101}}. Throws ReadError naming the file, the field and what it may be.
PlacementOverrides read_placement(const std::filesystem::path& file);

/// Puts the landmarks given in place of those found.
void apply_landmarks(const PlacementOverrides& overrides, Body& body);

}  // namespace regarment
