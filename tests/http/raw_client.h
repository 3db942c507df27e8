#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace regarment {

/// A TCP connection to 127.0.0.1 that sends and receives bytes as they are told; nothing of HTTP is
/// shared with the server.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  /// False when the peer has closed.
  bool send(std::string_view bytes);
  /// No more is sent; the other direction stays open.
  void end_sending();
  /// What comes until `end` was seen (and what came with it), or the peer closed.
  std::string receive_until(std::string_view end);
  /// What comes until the peer closes.
  std::string receive_all();
  /// One answer: its header and as many bytes as Content-Length says.
  std::string receive_answer();

 private:
  bool receive_some();

  int socket_ = -1;
  std::string received_;  // and not yet handed out
};

/// One request on a connection of its own, which sends nothing after it.
std::string ask(std::uint16_t port, std::string_view request);

/// The status of an answer: 200.
int status_of(std::string_view answer);
/// What follows the header.
std::string body_of(std::string_view answer);
/// A header's value; "-" when it is not there.
std::string field_of(std::string_view answer, std::string_view name);

}  // namespace regarment
