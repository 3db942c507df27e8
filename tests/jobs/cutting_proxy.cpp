#include "cutting_proxy.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <string_view>
#include <vector>

namespace regarment {
namespace {

constexpr const char* kName = ".s.PGSQL.5432";
constexpr int kLook = 10;  // ms, between two looks whether to end

sockaddr_un address_of(const std::filesystem::path& folder) {
  sockaddr_un out{};
  out.sun_family = AF_UNIX;
  (folder / kName).string().copy(out.sun_path, sizeof(out.sun_path) - 1);
  return out;
}

// false: the other end is gone.
bool pass_on(int from, int to, std::string& seen) {
  std::array<char, 65536> bytes;
  const ssize_t count = ::read(from, bytes.data(), bytes.size());
  if (count <= 0) return false;
  seen.assign(bytes.data(), static_cast<std::size_t>(count));
  return to < 0 || ::send(to, bytes.data(), seen.size(), MSG_NOSIGNAL) == count;
}

}  // namespace

CuttingProxy::CuttingProxy(const std::filesystem::path& server, const std::filesystem::path& own)
    : server_(server), listener_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_un address = address_of(own);
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  if (::bind(listener_, generic, sizeof(address)) != 0 || ::listen(listener_, 8) != 0) {
    throw std::filesystem::filesystem_error("proxy", own, {});
  }
  thread_ = std::thread([this] { serve(); });
}

CuttingProxy::~CuttingProxy() {
  ending_ = true;
  thread_.join();
  ::close(listener_);
}

void CuttingProxy::serve() {
  std::vector<std::thread> connections;
  while (!ending_) {
    pollfd waiting{listener_, POLLIN, 0};
    if (::poll(&waiting, 1, kLook) <= 0) continue;
    const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    const int server = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_un address = address_of(server_);
    // Where nobody is, the first byte says so.
    (void)::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof(address));
    connections.emplace_back([this, client, server] {
      pass(client, server);
      ::close(client);
      ::close(server);
    });
  }
  for (std::thread& one : connections) one.join();
}

void CuttingProxy::pass(int client, int server) {
  std::string seen;
  while (!ending_) {
    std::array<pollfd, 2> ends = {{{client, POLLIN, 0}, {server, POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), kLook) <= 0) continue;
    if (ends[1].revents != 0 && !pass_on(server, client, seen)) return;
    if (ends[0].revents == 0) continue;
    std::array<char, 64> head{};
    const ssize_t peeked = ::recv(client, head.data(), head.size(), MSG_PEEK);
    const std::string_view words(head.data(), peeked > 0 ? static_cast<std::size_t>(peeked) : 0);
    const Cut cut = words.find("COMMIT") == std::string_view::npos ? Cut::None : cut_.load();
    if (cut == Cut::BeforeCommit) {
      cut_ = Cut::None;
      return;
    }
    if (!pass_on(client, server, seen)) return;
    if (cut == Cut::AfterCommit) {
      pass_on(server, -1, seen);  // the answer, so that it was kept for certain
      cut_ = Cut::None;
      return;
    }
  }
}

}  // namespace regarment
