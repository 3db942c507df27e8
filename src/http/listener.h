#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <utility>

namespace regarment {

/// A listening TCP socket with a thread that accepts.
class Listener {
 public:
  /// `address` is an IPv4 or IPv6 address; port 0 is any free one. Throws UsageError when it cannot
  /// be had.
  Listener(const std::string& address, std::uint16_t port);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  std::uint16_t port() const { return port_; }
  bool ipv6() const { return ipv6_; }

  /// Begins to accept; `take` gets each connection's descriptor, non-blocking, which it then owns.
  void start(std::function<void(int descriptor)> take);
  /// Accepts no more, and closes the socket. `take` is not called any more once this returns.
  void stop();

 private:
  void accept_all();

  int socket_ = -1;
  int wake_ = -1;  // an eventfd: readable once the thread is to end
  std::uint16_t port_ = 0;
  bool ipv6_ = false;
  std::function<void(int)> take_;
  std::thread thread_;
};

}  // namespace regarment
