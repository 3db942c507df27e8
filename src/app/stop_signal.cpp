#include "app/stop_signal.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <string>

namespace regarment {
namespace {

constexpr timespec kPatience{2, 0};

std::atomic<int> stopped_by{0};
std::atomic<bool> told{false};

// By the thread that gets here first: the program's own way out, or the watcher whose patience
// ends.
void tell_once(int signal) {
  if (told.exchange(true)) return;
  const std::string line = std::string("regarment: stopped by ") +
                           (signal == SIGINT ? "SIGINT" : "SIGTERM") +
                           "; nothing half written, run it again to have the result\n";
  // Nothing is left to be told when this cannot be written.
  (void)!::write(STDERR_FILENO, line.data(), line.size());
}

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
  tell_once(got);
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

int StopSignal::tell() const {
  tell_once(stopped_by);
  return exit_status();
}

}  // namespace regarment
