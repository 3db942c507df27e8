#include "service/notify.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace regarment {

void notify_manager(const std::string& state) {
  const char* name = std::getenv("NOTIFY_SOCKET");
  sockaddr_un where{};
  where.sun_family = AF_UNIX;
  if (name == nullptr || std::strlen(name) < 2 || std::strlen(name) >= sizeof where.sun_path)
    return;
  std::memcpy(where.sun_path, name, std::strlen(name));
  if (name[0] == '@') where.sun_path[0] = '\0';  // a name that is in no folder
  const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return;
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + std::strlen(name));
  // Nobody is told when this fails: the manager is not there.
  (void)::sendto(socket, state.data(), state.size(), MSG_NOSIGNAL,
                 reinterpret_cast<const sockaddr*>(&where), size);
  ::close(socket);
}

std::optional<std::chrono::microseconds> watchdog_interval() {
  const char* text = std::getenv("WATCHDOG_USEC");
  const long long interval = text == nullptr ? 0 : std::atoll(text);
  if (interval <= 0) return std::nullopt;
  return std::chrono::microseconds(interval / 2);
}

}  // namespace regarment
