#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "http/headers.h"
#include "http/link.h"

namespace regarment {

/// What a client allows. Larger values wait longer for a slow server, and for one that does harm.
struct ClientOptions {
  std::string key;  // sent as a bearer; empty: none
  std::chrono::milliseconds connect_time{10'000};
  std::chrono::milliseconds answer_time{120'000};  // until the header of an answer is there
  std::chrono::milliseconds idle_time{30'000};     // between two pieces of a body
  std::size_t header_bytes = 16384;                // of an answer
};

struct ClientRequest {
  std::string method, target;  // "GET", "/v1/work": encoded
  Headers headers = {};        // beside Host, Authorization, length and expectation
  std::string body = {};
  std::optional<std::filesystem::path> file = {};  // sent instead of `body`, as long as it is then
};

/// Line and header of an answer.
struct ClientAnswer {
  int status = 0;
  Headers headers;
  std::string body;  // what no AnswerBody took

  bool is_good() const { return status >= 200 && status < 300; }
};

/// Takes the body of a good answer as it comes. What it throws ends the request.
class AnswerBody {
 public:
  virtual ~AnswerBody() = default;
  virtual void begin(const ClientAnswer& answer) = 0;
  virtual void take(std::string_view bytes) = 0;
};

/// An HTTP/1.1 client of one server. A connection is kept for the next request; one that was closed
/// meanwhile is made anew. Redirections are answers like others: nothing follows them. One thread.
class HttpClient {
 public:
  /// Throws UsageError for a key that no header can hold.
  HttpClient(HttpAddress address, ClientOptions options);
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  const HttpAddress& address() const { return address_; }

  /// Asks, and gathers at most `most` bytes of the answer's body. A file is sent once the server
  /// said that it wants it ("100-continue"), or said nothing for a second. Throws AwayError when
  /// the server is away, breaks off, is too slow or sends what is no answer or a longer one,
  /// Stopped when `go` answered false, ReadError when the file cannot be read.
  ClientAnswer ask(const ClientRequest& request, std::size_t most, const KeepGoing& go);
  /// The same; `body` takes what a good answer has, however long it is.
  ClientAnswer ask(const ClientRequest& request, AnswerBody& body, const KeepGoing& go);

 private:
  class Conversation;
  ClientAnswer ask(const ClientRequest& request, AnswerBody* body, std::size_t most,
                   const KeepGoing& go);

  HttpAddress address_;
  ClientOptions options_;
  std::unique_ptr<Link> link_;  // kept from the request before, or null
};

/// `text` as one segment of a path or a value of a query: everything but letters, digits and -._~
/// is percent-encoded.
std::string url_encoded(std::string_view text);

}  // namespace regarment
