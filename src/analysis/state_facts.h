#pragma once

#include "analysis/state_bytes.h"
#include "scan/scan.h"

namespace regarment {

/// What is known about a scan's file, as part of a state (analysis/scan_state.h).
void write_facts(const ScanFacts& facts, StateWriter& out);

/// Reads it back. Throws ReadError for figures, names and texts that no scan has.
ScanFacts read_facts(StateReader& in);

}  // namespace regarment
