#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "placement/placement_file.h"
#include "scan/scan.h"

namespace regarment {

/// What another fit of the same scan needs, so that nothing has to be read and prepared again.
struct ScanState {
  Scan scan;
  PlacementOverrides placement;           // as the placement file said
  std::vector<std::uint8_t> true_labels;  // one per vertex; or empty
};

/// The state as a file. Positions are kept as floats in the body frame, normals to 0.01 degrees,
/// everything else exactly; about 30 bytes a vertex of a mesh, 20 of a cloud. A fit works on what
/// is read back, so that it and a later one see the same scan.
///
/// "regarment.state\n", then u32 version, u64 length and SHA-256 (64 hexadecimal digits) of the
/// rest; little-endian. Throws InvalidInput when the sizes contradict each other.
std::string write_state(const ScanState& state);

/// Reads it back. The bytes may come from anywhere: sizes, indices and numbers are checked. Throws
/// ReadError in one line, with `name` in front, for another version or a file that is broken.
ScanState read_state(std::string_view bytes, const std::string& name);

}  // namespace regarment
