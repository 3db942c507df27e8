#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string_view>

#include "http/address.h"

namespace regarment {

/// Asked ten times a second while something is awaited; what is awaited ends (Stopped) when it
/// answers false. May itself take its time.
using KeepGoing = std::function<bool()>;

/// A connection to a server, plain or by TLS 1.2 or newer. With TLS the server's certificate must
/// be valid, for the host's name or address, by the system's store, or by what SSL_CERT_FILE and
/// SSL_CERT_DIR name. Everything that goes wrong throws AwayError; a broken connection is of no
/// more use. One thread. The process ignores SIGPIPE.
class Link {
 public:
  /// Looks the name up, connects to the first of its addresses that answers, and shakes hands:
  /// `most` for each of these.
  Link(const HttpAddress& address, std::chrono::milliseconds most, const KeepGoing& go);
  ~Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// At least one byte, at most `size`, awaited for `most`; 0: the peer has closed.
  std::size_t read(char* to, std::size_t size, std::chrono::milliseconds most, const KeepGoing& go);
  /// All of them; the peer must take some within each `most`.
  void write(std::string_view bytes, std::chrono::milliseconds most, const KeepGoing& go);
  /// Whether something arrives, the peer's end included, within `most`.
  bool arrives(std::chrono::milliseconds most, const KeepGoing& go);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace regarment
