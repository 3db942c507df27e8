#include "http/server.h"

#include "http/connections.h"
#include "http/listener.h"

namespace regarment {

struct Server::Inside {
  Connections connections;
  Listener listener;

  Inside(const ServerOptions& options, Handler& handler)
      : connections(options, handler), listener(options.address, options.port) {}
};

Server::Server(const ServerOptions& options, Handler& handler) {
  options.check();
  inside_ = std::make_unique<Inside>(options, handler);
  inside_->listener.start(
      [this](int descriptor) { inside_->connections.take(descriptor, inside_->listener.ipv6()); });
}

Server::~Server() { stop(); }

std::uint16_t Server::port() const { return inside_->listener.port(); }

std::size_t Server::connections() const { return inside_->connections.count(); }

void Server::stop() {
  inside_->listener.stop();
  inside_->connections.stop();
}

}  // namespace regarment
