#pragma once

#include <string>

namespace regarment {

/// How a command speaks.
struct Speech {
  bool quiet = false;             // no progress on standard error
  bool json = false;              // the result as JSON on standard output
  std::string progress = "auto";  // "json": a JSON object a line, for programs
};

}  // namespace regarment
