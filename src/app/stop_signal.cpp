#include "app/stop_signal.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <string>

namespace regarment {
namespace {

std::atomic<int> stopped_by{0};
std::atomic<bool> told{false};
std::atomic<std::int64_t> patience{2000};  // ms

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
  const std::int64_t milliseconds = patience;
  const timespec time{milliseconds / 1000, milliseconds % 1000 * 1'000'000};
  if (sigtimedwait(&set, nullptr, &time) == SIGUSR1) return;
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

void StopSignal::allow(std::chrono::milliseconds time) const { patience = time.count(); }

int StopSignal::exit_status() const { return stopped_by == 0 ? 0 : 128 + stopped_by; }

int StopSignal::tell() const {
  tell_once(stopped_by);
  return exit_status();
}

}  // namespace regarment
