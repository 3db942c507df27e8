#pragma once

#include <cstdint>
#include <string>

namespace regarment {

/// Where an HTTP server is.
struct HttpAddress {
  bool tls = false;
  std::string host;  // a name, or an IP address without brackets
  std::uint16_t port = 80;

  /// "http://HOST", "https://HOST:PORT", "http://[::1]:8080/". Throws UsageError, which repeats
  /// nothing of the text, for anything else: a path, a query, a user's name or password.
  static HttpAddress parse(const std::string& text);

  /// As `parse` reads it, with its port: "https://studio:443".
  std::string text() const;
  /// What a request to it says as Host.
  std::string authority() const;
  /// Whether what is sent there stays on this machine.
  bool is_loopback() const;
};

}  // namespace regarment
