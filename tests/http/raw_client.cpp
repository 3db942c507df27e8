#include "raw_client.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace regarment {
namespace {

constexpr std::string_view kHeaderEnd = "\r\n\r\n";

}  // namespace

RawClient::RawClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_port = htons(port);
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&where), sizeof where) != 0)
    throw std::runtime_error("nobody listens");
}

RawClient::~RawClient() { ::close(socket_); }

bool RawClient::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

void RawClient::end_sending() { ::shutdown(socket_, SHUT_WR); }

bool RawClient::receive_some() {
  std::array<char, 65536> block;
  const ssize_t got = ::recv(socket_, block.data(), block.size(), 0);
  if (got > 0) received_.append(block.data(), static_cast<std::size_t>(got));
  return got > 0;
}

std::string RawClient::receive_until(std::string_view end) {
  std::size_t found = received_.find(end);
  while (found == std::string::npos && receive_some()) found = received_.find(end);
  const std::size_t size = found == std::string::npos ? received_.size() : found + end.size();
  std::string out = received_.substr(0, size);
  received_.erase(0, size);
  return out;
}

std::string RawClient::receive_all() {
  while (receive_some()) {
  }
  return std::exchange(received_, {});
}

std::string RawClient::receive_answer() {
  std::string out = receive_until(kHeaderEnd);
  const std::string length = field_of(out, "Content-Length");
  const std::size_t size = length == "-" ? 0 : std::stoul(length);
  while (received_.size() < size && receive_some()) {
  }
  out += received_.substr(0, size);
  received_.erase(0, size);
  return out;
}

std::string ask(std::uint16_t port, std::string_view request) {
  RawClient client(port);
  client.send(request);
  client.end_sending();
  return client.receive_all();
}

int status_of(std::string_view answer) {
  return answer.starts_with("HTTP/1.1 ") ? std::stoi(std::string(answer.substr(9, 3))) : 0;
}

std::string body_of(std::string_view answer) {
  const std::size_t end = answer.find(kHeaderEnd);
  return end == std::string_view::npos ? "" : std::string(answer.substr(end + kHeaderEnd.size()));
}

std::string field_of(std::string_view answer, std::string_view name) {
  const std::string begin = "\r\n" + std::string(name) + ": ";
  const std::string_view header = answer.substr(0, answer.find(kHeaderEnd) + 2);
  const std::size_t at = header.find(begin);
  if (at == std::string_view::npos) return "-";
  const std::string_view rest = header.substr(at + begin.size());
  return std::string(rest.substr(0, rest.find("\r\n")));
}

}  // namespace regarment
