#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "batch/batch_folder.h"
#include "batch/manifest.h"

namespace regarment {

/// Tries a scan has before it is parked.
inline constexpr int kMostAttempts = 3;

struct RunScansOptions {
  std::filesystem::path program;  // absolute; that of the manifest
  int at_once = 1;                // fits, each a process of one thread; >= 1
};

/// Who is told how it goes, in the calling thread. What either throws stops the work; the fits at
/// work are then ended and cost their scans no attempt.
struct RunScansTold {
  std::function<void(std::size_t scan, const ScanStatus&)> done;
  std::function<void()> still_wanted;  // several times a second
};

/// Fits these scans of the manifest, which have no status yet, those with the fewest attempts
/// first, until each has one: a fit that crashes, is killed or ends in a temporary failure is tried
/// again after the others, and parked after kMostAttempts; other failures are final at once.
/// Attempts count across processes, for they are noted before a fit begins: a scan that takes
/// whatever runs it down with it is parked too. Throws TemporaryError when nothing can be written
/// or started.
void run_scans(const BatchFolder& folder, const Manifest& manifest,
               const std::vector<std::size_t>& scans, const RunScansOptions& options,
               const RunScansTold& told);

}  // namespace regarment
