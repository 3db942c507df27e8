#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "base/away_error.h"
#include "http/server.h"

namespace regarment {

/// A handler for tests: /quick answers at once, /echo gives back the body, /count its length,
/// /deep/* what is asked for, /refuse and /crash throw before the body, /late after it, /file sends
/// a file, /events three events and an end, /endless events until told to stop, /hold waits until
/// `release`.
class EchoHandler : public Handler {
 public:
  static constexpr std::uint64_t kLimit = 1'000'000;  // bytes of a body

  std::filesystem::path folder;  // of /file

  std::optional<Response> at_once(const Request& request) override {
    if (request.path != std::vector<std::string>{"quick"}) return std::nullopt;
    return text_response(200, "text/plain", "quick");
  }

  std::unique_ptr<Exchange> begin(const Request& request) override {
    const std::string what = request.path.empty() ? "" : request.path[0];
    if (what == "refuse") throw HttpProblem(401, "no_key", "no key", {{"X-Why", "test"}});
    if (what == "crash") throw std::runtime_error("a secret of the inside");
    if (what == "away") throw AwayError("secret: the store is away");
    if (what == "full") throw TemporaryError("the disk is full");
    return std::make_unique<Echo>(*this, request, what);
  }

  void served(const Request*, const Served& served) override {
    const std::lock_guard lock(mutex_);
    served_.push_back(served.status);
    changed_.notify_all();
  }

  /// Waits until so many requests were told of; their statuses.
  std::vector<int> wait_for_served(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return served_.size() >= count; });
    return served_;
  }
  void wait_until_held() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return held_; });
  }
  void release() {
    const std::lock_guard lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }

 private:
  class Count : public EventStream {
   public:
    explicit Count(bool endless) : endless_(endless) {}
    Part next() override {
      if (++number_ > 3 && endless_) return {};
      return {"id: " + std::to_string(number_) + "\n\n", number_ == 3 && !endless_};
    }

   private:
    bool endless_;
    int number_ = 0;
  };

  class Echo : public Exchange {
   public:
    Echo(EchoHandler& owner, Request request, std::string what)
        : owner_(owner), request_(std::move(request)), what_(std::move(what)) {}
    std::uint64_t body_limit() const override { return kLimit; }
    void take(std::string_view bytes) override {
      count_ += bytes.size();
      if (what_ == "echo") text_.append(bytes);
    }
    Response finish() override {
      if (what_ == "late") throw UsageError("too late");
      if (what_ == "file") return *file_response(request_, owner_.folder, "a", "text/plain");
      if (what_ == "hold") owner_.hold();
      Response out = text_response(200, "text/plain", what_ == "echo" ? text_ : "");
      if (what_ == "count") out.body = std::to_string(count_);
      if (what_ == "events" || what_ == "endless")
        out.events = std::make_unique<Count>(what_ == "endless");
      return out;
    }

   private:
    EchoHandler& owner_;
    Request request_;
    std::string what_, text_;
    std::size_t count_ = 0;
  };

  void hold() {
    std::unique_lock lock(mutex_);
    held_ = true;
    changed_.notify_all();
    changed_.wait(lock, [&] { return released_; });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<int> served_;
  bool held_ = false, released_ = false;
};

}  // namespace regarment
