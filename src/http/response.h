#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "http/problem.h"
#include "http/request.h"

namespace regarment {

/// A part of a file that is sent as it stands when its time comes.
struct FileBody {
  std::shared_ptr<void> keeps;  // closes the descriptor with the last copy
  int descriptor = -1;
  std::uint64_t begin = 0, end = 0;  // bytes, end exclusive
};

/// Text that goes on arriving (server-sent events).
class EventStream {
 public:
  virtual ~EventStream() = default;

  struct Part {
    std::string bytes;   // whole frames; may be empty
    bool ended = false;  // nothing follows
  };
  /// What came since the last call. Asked a few times a second by one thread at a time; may read
  /// files or a store.
  virtual Part next() = 0;
};

/// The answer to a request. Exactly one of body, file and events is used.
struct Response {
  int status = 200;
  std::string content_type;  // empty: none is said
  Headers headers;           // beside type, length, date, connection
  std::string body;
  std::optional<FileBody> file;
  std::unique_ptr<EventStream> events;
};

Response text_response(int status, std::string content_type, std::string body);

/// RFC 9457: {"type", "title", "status", "detail", "code", "request_id"}.
Response problem_response(const HttpProblem& problem, const std::string& request_id);

/// A file with its ETag, made of size, time and number: 304 when If-None-Match has it, 206 for one
/// byte range that the file has, 416 for one it has not; several ranges are answered by the whole
/// file. Symbolic links are not followed, neither at the end of `file` nor, when it lies in a
/// folder, on the way from `root`. Nothing when there is no such regular file.
std::optional<Response> file_response(const Request& request, const std::filesystem::path& root,
                                      const std::filesystem::path& file, std::string content_type);

/// Adds the body's ETag (its SHA-256); an If-None-Match that has it turns the answer into 304.
Response with_etag(const Request& request, Response response);

}  // namespace regarment
