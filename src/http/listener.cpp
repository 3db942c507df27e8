#include "http/listener.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr int kBacklog = 4096;
constexpr int kPause = 50;  // ms, when there are no descriptors left

union Address {
  sockaddr any;
  sockaddr_in v4;
  sockaddr_in6 v6;
};

Address address_of(const std::string& text, std::uint16_t port) {
  Address out{};
  if (::inet_pton(AF_INET, text.c_str(), &out.v4.sin_addr) == 1) {
    out.v4.sin_family = AF_INET;
    out.v4.sin_port = htons(port);
  } else if (::inet_pton(AF_INET6, text.c_str(), &out.v6.sin6_addr) == 1) {
    out.v6.sin6_family = AF_INET6;
    out.v6.sin6_port = htons(port);
  } else {
    throw UsageError("address: '" + one_line(text, 60) +
                     "' is no IP address; give one such as 127.0.0.1");
  }
  return out;
}

}  // namespace

Listener::Listener(const std::string& address, std::uint16_t port) {
  Address where = address_of(address, port);
  ipv6_ = where.any.sa_family == AF_INET6;
  socklen_t size = ipv6_ ? sizeof where.v6 : sizeof where.v4;
  socket_ = ::socket(where.any.sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  wake_ = ::eventfd(0, EFD_CLOEXEC);
  const int on = 1;
  const bool ready = socket_ >= 0 && wake_ >= 0 &&
                     ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
                     ::bind(socket_, &where.any, size) == 0 && ::listen(socket_, kBacklog) == 0 &&
                     ::getsockname(socket_, &where.any, &size) == 0;
  if (!ready) {
    const std::string reason = std::strerror(errno);
    stop();
    throw UsageError("port " + std::to_string(port) + " of " + address + ": " + reason +
                     "; choose another, or 0 for any free one");
  }
  port_ = ntohs(ipv6_ ? where.v6.sin6_port : where.v4.sin_port);
}

Listener::~Listener() { stop(); }

void Listener::start(std::function<void(int)> take) {
  take_ = std::move(take);
  thread_ = std::thread([this] { accept_all(); });
}

void Listener::stop() {
  if (thread_.joinable()) {
    ::eventfd_write(wake_, 1);
    thread_.join();
  }
  for (int* descriptor : {&socket_, &wake_})
    if (*descriptor >= 0) ::close(std::exchange(*descriptor, -1));
}

void Listener::accept_all() {
  std::array<pollfd, 2> waits{pollfd{socket_, POLLIN, 0}, pollfd{wake_, POLLIN, 0}};
  while (true) {
    ::poll(waits.data(), waits.size(), -1);
    if (waits[1].revents != 0) return;
    const int connection = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (connection >= 0) {
      take_(connection);
    } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
      // Asking again at once would only spin.
      ::poll(&waits[1], 1, kPause);
    }
  }
}

}  // namespace regarment
