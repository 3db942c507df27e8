#pragma once

#include <optional>
#include <string>

#include "evaluation/evaluated_scan.h"

namespace regarment {

/// What became of a scan of a batch, for good.
struct ScanStatus {
  /// Succeeded: its result stands. Failed: it has none, for a reason of its own. Parked: whatever
  /// fitted it ended badly again and again.
  enum class State { Succeeded, Failed, Parked };
  State state = State::Succeeded;
  std::string name, key;               // of BatchScan
  std::string result_sha256;           // of result.json; empty unless it succeeded
  std::optional<ScanFailure> failure;  // there unless it succeeded
};

/// "succeeded", "failed" or "parked".
std::string name_of(ScanStatus::State state);

/// One line of JSON with its end.
std::string status_json(const ScanStatus& status);

/// Reads it back; nothing when it is none, as of a file that was cut off.
std::optional<ScanStatus> parse_status(const std::string& json);

}  // namespace regarment
