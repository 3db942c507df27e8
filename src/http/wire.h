#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "http/response.h"

namespace regarment {

/// How an answer goes over the wire.
struct WireHead {
  bool keep_alive = true;
  bool chunked = false;  // of event streams, to clients of HTTP/1.1
  std::string request_id;
};

/// Status line and all header fields, with the empty line after them. Header values lose control
/// characters. An answer that says nothing else gets a Content-Security-Policy that allows nothing,
/// and "Cache-Control: no-store".
std::string wire_head(const Response& response, const WireHead& how);

/// One piece in chunked coding; an empty one is the last.
std::string wire_chunk(std::string_view bytes);

/// The answer to an exception that left a handler; `internal_error` becomes what a client is not
/// told of a 500. Call it in a catch block.
Response response_to_current_exception(const std::string& request_id, std::string& internal_error);

/// A body's bytes one block after the other, from memory or from a file.
class BodyBlocks {
 public:
  explicit BodyBlocks(Response response);
  /// Whether `next` reads a file, which may take its time.
  bool reads_file() const { return response_.file.has_value(); }
  /// At most 64 KiB of a file, or all that is in memory, valid until the next call; empty at the
  /// end. Nothing when the file became shorter than was told or cannot be read.
  std::optional<std::string_view> next();

 private:
  Response response_;
  std::string block_;
  bool done_ = false;
};

/// An event stream as it goes over the wire.
class EventBytes {
 public:
  /// To a client of HTTP/1.1 `chunked`, to an older one as it is.
  EventBytes(std::unique_ptr<EventStream> events, bool chunked);

  struct Part {
    std::string bytes;   // empty: nothing to send now
    bool ended = false;  // nothing follows
  };
  /// Asks the stream once. A silence of 15 s becomes a comment, by which a client that went away is
  /// noticed; `stop` ends the stream, and so does what it throws, without the last chunk.
  Part next(bool stop);

 private:
  using Clock = std::chrono::steady_clock;

  std::unique_ptr<EventStream> events_;
  bool chunked_;
  Clock::time_point last_ = Clock::now();  // when something was sent
};

}  // namespace regarment
