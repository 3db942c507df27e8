#pragma once

#include <string>

#include "batch/batch_folder.h"
#include "batch/batch_state.h"

namespace regarment {

/// What was measured on all scans that succeeded, as CSV: a row per scan and dimension, in the
/// order of the manifest, all of which have ended. Columns: scan, and those of a fit's
/// measurements.csv from layer to observable. Throws ReadError when a result has none that can be
/// read.
std::string measurements_table(const BatchFolder& folder, const Manifest& manifest,
                               const BatchState& state);

}  // namespace regarment
