#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "http/listener.h"

namespace regarment {

/// A server that answers each connection by a script, right or wrong: it waits for the header of a
/// request, sends the next text it was given, and closes. Without a text left it closes at once.
class ScriptedPeer {
 public:
  ScriptedPeer();
  ~ScriptedPeer();
  ScriptedPeer(const ScriptedPeer&) = delete;
  ScriptedPeer& operator=(const ScriptedPeer&) = delete;

  std::uint16_t port() const { return listener_.port(); }
  /// The answer to the next connection; sent again and again when `endless`, and the connection
  /// stays open after it when `held`.
  void answer(std::string text, bool endless = false, bool held = false);
  /// The headers of all requests that came.
  std::vector<std::string> requests();

 private:
  struct Answer {
    std::string text;
    bool endless = false, held = false;
  };
  void serve(int connection);

  std::mutex mutex_;
  std::deque<Answer> answers_;
  std::vector<std::string> requests_;
  std::vector<int> held_;
  Listener listener_{"127.0.0.1", 0};
};

/// An answer with this body and its true length.
std::string good_answer(const std::string& body, const std::string& fields = "");

}  // namespace regarment
