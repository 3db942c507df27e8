#pragma once

#include <functional>
#include <string>

#include "app/command_line.h"
#include "base/progress.h"
#include "base/stage_cache.h"
#include "scan/scan.h"

namespace regarment {

/// --name, or the file's.
std::string name_of_scan(const FitArguments& a);

struct PreparedScan {
  Scan scan;           // as read back from `stored`
  std::string stored;  // a state of the scan alone
};

/// Reads the scan file of a fit and prepares it; or, with a cache, takes what an earlier fit of the
/// same bytes by the same program has prepared, with the same unit and axes. Both give the same.
/// `lap` is told when each of the two stages ends. Throws as read_mesh_sandboxed and make_scan.
PreparedScan prepared_scan(const FitArguments& a, const StageCache* cache, const Progress& progress,
                           const std::function<void(const char* stage)>& lap);

}  // namespace regarment
