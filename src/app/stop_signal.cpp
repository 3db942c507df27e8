#include "app/stop_signal.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace regarment {
namespace {

constexpr timespec kPatience{2, 0};

std::atomic<int> stopped_by{0};

// SIGUSR1 is how the destructor tells the watcher that the program ended by itself.
sigset_t watched() {
  sigset_t set;
  sigemptyset(&set);
  for (const int one : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&set, one);
  return set;
}

void watch() {
  const sigset_t set = watched();
  int got = 0;
  if (sigwait(&set, &got) != 0 || got == SIGUSR1) return;
  stopped_by = got;
  if (sigtimedwait(&set, nullptr, &kPatience) == SIGUSR1) return;
  ::_exit(128 + got);
}

}  // namespace

StopSignal::StopSignal() {
  ::signal(SIGPIPE, SIG_IGN);
  const sigset_t set = watched();
  // Every later thread inherits the mask, so only the watcher sees these signals.
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  watcher_ = std::thread(watch);
}

StopSignal::~StopSignal() {
  ::pthread_kill(watcher_.native_handle(), SIGUSR1);
  watcher_.join();
}

bool StopSignal::asked() const { return stopped_by != 0; }

int StopSignal::exit_status() const { return stopped_by == 0 ? 0 : 128 + stopped_by; }

}  // namespace regarment
