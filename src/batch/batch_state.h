#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch_folder.h"
#include "batch/manifest.h"

namespace regarment {

/// How far a batch is.
struct BatchState {
  std::vector<std::optional<ScanStatus>> scans;  // one per scan of the manifest; none: to be done
  std::vector<int> attempts;                     // tries of each that have not ended
  std::size_t succeeded = 0, failed = 0, parked = 0;
  bool merged = false;  // they are summed up

  std::size_t ended() const { return succeeded + failed + parked; }
};

BatchState batch_state(const BatchFolder& folder, const Manifest& manifest);

/// "12 of 30 scans: 10 succeeded, 1 failed, 1 parked, 18 to be done"; when all have ended and are
/// not summed up, that too.
std::string state_line(const BatchState& state);

/// That line, then a line for each scan that failed or is parked, with its reason, and each that
/// ended badly so far.
std::string state_text(const Manifest& manifest, const BatchState& state);

/// {"scans", "succeeded", "failed", "parked", "to_be_done", "merged", "status": [...]}
std::string state_json(const Manifest& manifest, const BatchState& state);

}  // namespace regarment
