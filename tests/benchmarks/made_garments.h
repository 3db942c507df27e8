#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "garment/pattern.h"

namespace regarment {

/// A garment of a case of `regarment synthesize`, as it truly lies, on a coarse pattern.
struct MadeGarment {
  std::string name;  // "case-0007.garment1"
  std::string template_name;
  Dimensions flat, worn;            // m
  Dimensions laid;                  // m, worn, or the nearest to it that makes a garment
  std::vector<std::string> hidden;  // dimensions the scan does not show
  Pattern pattern;                  // flat at `laid`
  std::vector<Vec3> draped;         // per pattern vertex, m, the scan's axes
};

/// All garments of the folder's truth/truth.json, with pattern edges of `edge_length` metres.
/// Throws ReadError.
std::vector<MadeGarment> read_made_garments(const std::filesystem::path& folder,
                                            double edge_length);

/// Adds a smooth random displacement, `rms` metres in all, of wavelengths from 6 to 15 cm: a
/// stand-in for the error of cloth fitted to a scan.
void disturb(std::vector<Vec3>& positions, double rms, std::uint64_t seed);

}  // namespace regarment
