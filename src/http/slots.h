#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

namespace regarment {

/// A number of places that are taken and given back, from any thread.
class Slots {
 public:
  explicit Slots(std::size_t most) : most_(most) {}

  /// A place, given back with the last copy; null when all are taken. Must not outlive the slots.
  std::shared_ptr<void> take() {
    if (++taken_ > most_) {
      --taken_;
      return nullptr;
    }
    return {this, [this](void*) { --taken_; }};
  }

 private:
  std::size_t most_;
  std::atomic<std::size_t> taken_{0};
};

}  // namespace regarment
