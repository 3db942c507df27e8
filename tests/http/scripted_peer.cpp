#include "scripted_peer.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace regarment {
namespace {

std::string received_header(int connection) {
  std::string out;
  std::array<char, 4096> block;
  while (out.find("\r\n\r\n") == std::string::npos) {
    const ssize_t got = ::recv(connection, block.data(), block.size(), 0);
    if (got <= 0) break;
    out.append(block.data(), static_cast<std::size_t>(got));
  }
  return out;
}

bool send_all(int connection, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

}  // namespace

ScriptedPeer::ScriptedPeer() {
  listener_.start([this](int connection) { serve(connection); });
}

ScriptedPeer::~ScriptedPeer() {
  listener_.stop();
  for (const int connection : held_) ::close(connection);
}

void ScriptedPeer::answer(std::string text, bool endless, bool held) {
  const std::lock_guard lock(mutex_);
  answers_.push_back({std::move(text), endless, held});
}

std::vector<std::string> ScriptedPeer::requests() {
  const std::lock_guard lock(mutex_);
  return requests_;
}

void ScriptedPeer::serve(int connection) {
  ::fcntl(connection, F_SETFL, 0);  // the listener hands it over non-blocking
  const std::string request = received_header(connection);
  Answer answer;
  {
    const std::lock_guard lock(mutex_);
    requests_.push_back(request);
    if (!answers_.empty()) answer = answers_.front(), answers_.pop_front();
  }
  while (send_all(connection, answer.text) && answer.endless) {
  }
  if (answer.held) {
    held_.push_back(connection);
    return;
  }
  // Closing over unread bytes would reset the connection, and the answer might be lost.
  ::shutdown(connection, SHUT_WR);
  std::array<char, 4096> rest;
  while (::recv(connection, rest.data(), rest.size(), 0) > 0) {
  }
  ::close(connection);
}

std::string good_answer(const std::string& body, const std::string& fields) {
  return "HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" + fields +
         "\r\n" + body;
}

}  // namespace regarment
