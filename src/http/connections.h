#pragma once

#include <cstddef>
#include <memory>

#include "http/server.h"

namespace regarment {

/// The open connections of a server, on threads of their own: each reads a request, lets the
/// handler answer it, and goes on with the next.
class Connections {
 public:
  Connections(const ServerOptions& options, Handler& handler);
  ~Connections();
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;

  /// Owns an accepted, non-blocking socket from here on; closes it at once when there are too many.
  void take(int descriptor, bool ipv6);
  std::size_t count() const;
  /// As Server::stop has it. Nothing is taken any more.
  void stop();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace regarment
