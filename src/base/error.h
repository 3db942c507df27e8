#pragma once

#include <stdexcept>
#include <string>

namespace regarment {

/// What every error of the project derives from. `what()` is one line for a person: what is wrong,
/// where, and what to do. `exit_status()` is the status of design decision "exit status" in the
/// README: 1 internal, 2 wrong usage, 3 unreadable or no person, 4 not the garment asked for,
/// 5 a gate failed, 75 temporary failure.
class Error : public std::runtime_error {
 public:
  Error(int exit_status, const std::string& message)
      : std::runtime_error(message), exit_status_(exit_status) {}
  int exit_status() const { return exit_status_; }

 private:
  int exit_status_;
};

/// The caller asked for something that does not exist or contradicts itself (exit status 2).
struct UsageError : Error {
  explicit UsageError(const std::string& message) : Error(2, message) {}
};

/// A file cannot be read as what it should be (exit status 3).
struct ReadError : Error {
  explicit ReadError(const std::string& message) : Error(3, message) {}
};

/// The scan was read but shows no person (exit status 3).
struct NoPersonError : Error {
  explicit NoPersonError(const std::string& message) : Error(3, message) {}
};

/// A person, but not the garment asked for, or no credible fit (exit status 4).
struct NoGarmentError : Error {
  explicit NoGarmentError(const std::string& message) : Error(4, message) {}
};

/// A condition on an evaluation does not hold (exit status 5).
struct GateError : Error {
  explicit GateError(const std::string& message) : Error(5, message) {}
};

/// Something outside failed that may work later: disk full, store away (exit status 75).
struct TemporaryError : Error {
  explicit TemporaryError(const std::string& message) : Error(75, message) {}
};

/// A library function was called with values outside its contract (exit status 1): our own mistake.
struct InvalidInput : Error {
  explicit InvalidInput(const std::string& message) : Error(1, message) {}
};

/// A progress callback answered "stop". `main` turns it into 130 or 143.
struct Stopped : Error {
  Stopped() : Error(130, "stopped") {}
};

}  // namespace regarment
