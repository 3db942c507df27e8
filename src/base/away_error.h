#pragma once

#include "base/error.h"

namespace regarment {

/// Something that others run, such as a database, cannot be had just now (exit status 75).
struct AwayError : TemporaryError {
  explicit AwayError(const std::string& message) : TemporaryError(message) {}
};

}  // namespace regarment
