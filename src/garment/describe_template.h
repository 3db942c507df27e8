#pragma once

#include <string>

#include "garment/garment_template.h"

namespace regarment {

/// A template as plain text for a terminal, lines of at most 88 characters: measurements with code,
/// definition, how to measure, typical value and bounds in cm; edges; sources. Ends with a newline.
std::string describe_template(const GarmentTemplate& garment);

}  // namespace regarment
