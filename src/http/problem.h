#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "http/headers.h"

namespace regarment {

/// A request that is answered with an error: the status, a stable `code` for programs
/// ("too_large"), and `what()`, one line for a person: what is wrong and what to do.
struct HttpProblem : Error {
  HttpProblem(int status_, std::string code_, const std::string& detail, Headers headers_ = {})
      : Error(2, detail), status(status_), code(std::move(code_)), headers(std::move(headers_)) {}

  int status;
  std::string code;
  Headers headers;  // beside the usual ones: Allow, Retry-After, WWW-Authenticate
};

/// The reason phrase of a status ("Not Found"); "Error" for one that is not known.
std::string_view status_phrase(int status);

// What the server itself finds wrong.

/// 414 "target_too_long" or 431 "header_too_large".
HttpProblem too_long_header(bool in_target);
/// 400 or 505 "bad_http".
HttpProblem bad_http(int status, std::string_view what);
/// 413 "too_large".
HttpProblem too_long_body(std::uint64_t limit);
/// 503 "too_many_streams" with Retry-After.
HttpProblem too_many_streams();

}  // namespace regarment
