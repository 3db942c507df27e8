#include "http/problem.h"

#include <algorithm>
#include <array>

#include "base/one_line.h"

namespace regarment {
namespace {

constexpr std::array<std::pair<int, std::string_view>, 30> kPhrases{{
    {200, "OK"},
    {201, "Created"},
    {202, "Accepted"},
    {204, "No Content"},
    {206, "Partial Content"},
    {303, "See Other"},
    {304, "Not Modified"},
    {400, "Bad Request"},
    {401, "Unauthorized"},
    {403, "Forbidden"},
    {404, "Not Found"},
    {405, "Method Not Allowed"},
    {408, "Request Timeout"},
    {409, "Conflict"},
    {410, "Gone"},
    {411, "Length Required"},
    {412, "Precondition Failed"},
    {413, "Content Too Large"},
    {414, "URI Too Long"},
    {415, "Unsupported Media Type"},
    {416, "Range Not Satisfiable"},
    {417, "Expectation Failed"},
    {421, "Misdirected Request"},
    {422, "Unprocessable Content"},
    {429, "Too Many Requests"},
    {431, "Request Header Fields Too Large"},
    {500, "Internal Server Error"},
    {503, "Service Unavailable"},
    {505, "HTTP Version Not Supported"},
    {507, "Insufficient Storage"},
}};

}  // namespace

std::string_view status_phrase(int status) {
  const auto found = std::find_if(kPhrases.begin(), kPhrases.end(),
                                  [&](const auto& entry) { return entry.first == status; });
  return found == kPhrases.end() ? "Error" : found->second;
}

HttpProblem too_long_header(bool in_target) {
  if (in_target)
    return {414, "target_too_long", "the address of the request is too long; shorten it"};
  return {431, "header_too_large", "the header is too large; send fewer or shorter fields"};
}

HttpProblem bad_http(int status, std::string_view what) {
  return {status, "bad_http", "this is no request of HTTP/1.1: " + one_line(what, 80)};
}

HttpProblem too_long_body(std::uint64_t limit) {
  return {413, "too_large",
          "the body is longer than the " + std::to_string(limit) +
              " bytes that are taken here; send less"};
}

HttpProblem too_many_streams() {
  return {503,
          "too_many_streams",
          "too many event streams are open; ask again later",
          {{"Retry-After", "5"}}};
}

}  // namespace regarment
