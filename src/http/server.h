#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "http/request.h"
#include "http/response.h"

namespace regarment {

/// One request that is being answered: takes its body, then answers. Its functions are called one
/// after the other, on threads that may wait for files and stores. They throw HttpProblem, which
/// becomes the answer; AwayError becomes 503, other TemporaryErrors 507, UsageError and ReadError
/// 422, others 500.
/// Destroyed without `finish` when the client goes away.
class Exchange {
 public:
  virtual ~Exchange() = default;
  /// Longest body taken, bytes; a longer one is answered 413 "too_large" as soon as it shows.
  virtual std::uint64_t body_limit() const { return 0; }
  virtual void take(std::string_view bytes) { (void)bytes; }
  virtual Response finish() = 0;
};

/// What a request came to, for logs and counters.
struct Served {
  int status = 0;  // 0: the client went away before an answer
  std::uint64_t bytes_in = 0, bytes_out = 0;
  double seconds = 0;
  std::string internal_error;  // of a 500: what is told to no client
};

/// What answers. Its functions are called from several threads at once.
class Handler {
 public:
  virtual ~Handler() = default;
  /// An answer that needs neither files nor a store nor the body, given on a network thread;
  /// nothing: `begin` is asked, on a thread that may wait.
  virtual std::optional<Response> at_once(const Request& request) {
    (void)request;
    return std::nullopt;
  }
  /// Looks at everything before the body and throws as `Exchange` does. Never null.
  virtual std::unique_ptr<Exchange> begin(const Request& request) = 0;
  /// Once for each answer that was begun, or whose client went away; `request` is null when its
  /// header could not be read. Must not throw.
  virtual void served(const Request* request, const Served& served) {
    (void)request;
    (void)served;
  }
};

/// What a server allows. Larger values let slower or heavier clients through and let attackers hold
/// more memory: about 12 KiB a connection, 64 KiB more while a body arrives.
struct ServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;                // 0: any free one
  int network_threads = 2;               // read and write; never wait
  int handler_threads = 4;               // run `begin`, `take`, `finish` and event streams
  std::size_t header_bytes = 8192;       // request line and header fields
  std::size_t connections = 4096;        // more are closed at once
  std::size_t event_streams = 256;       // more are answered 503
  std::chrono::seconds header_time{10};  // from the first byte awaited to the end of the header
  std::chrono::seconds idle_time{30};    // between two requests, and between two pieces of a body
  std::chrono::seconds body_time{1800};  // for a whole body
  std::chrono::seconds drain_time{10};   // for open requests once told to stop
  std::chrono::milliseconds event_poll{250};
  /// Throws UsageError naming the field and its value.
  void check() const;
};

/// An HTTP/1.1 server on threads of its own. Bodies are never gathered, nor are answers from files.
/// Every answer carries X-Request-Id and the headers of `wire_head`.
class Server {
 public:
  /// Listens from here on. Throws UsageError when the address cannot be had. The handler outlives
  /// the server.
  Server(const ServerOptions& options, Handler& handler);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const;
  /// Open connections, for a gauge.
  std::size_t connections() const;
  /// Takes no more connections, closes idle ones, ends event streams, waits for open requests for
  /// at most drain_time and closes what is left. Once; the destructor calls it when nobody did.
  void stop();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace regarment
