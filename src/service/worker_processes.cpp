#include "service/worker_processes.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <thread>

namespace regarment {
namespace {

constexpr std::chrono::milliseconds kFirstPause{500}, kLongestPause{30'000}, kAtOnce{5'000};

// Only calls that are safe between fork and exec.
[[noreturn]] void become_worker(char* const* words, pid_t parent) {
  constexpr int kNicer = 5;
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(1);
  (void)!::nice(kNicer);
  ::execv(words[0], words);
  ::_exit(127);
}

}  // namespace

WorkerProcesses::WorkerProcesses(std::vector<std::string> command, int count)
    : command_(std::move(command)), places_(static_cast<std::size_t>(count)) {}

WorkerProcesses::~WorkerProcesses() {
  for (const Place& place : places_) {
    if (place.process < 0) continue;
    ::kill(place.process, SIGKILL);
    ::waitpid(place.process, nullptr, 0);
  }
}

int WorkerProcesses::look_after() {
  int ended = 0;
  for (Place& place : places_) {
    if (reap(place)) ++ended;
    if (place.process < 0 && !ending_ && Clock::now() >= place.again) start(place);
  }
  return ended;
}

// Whether the process of this place was found ended just now.
bool WorkerProcesses::reap(Place& place) const {
  if (place.process < 0 || ::waitpid(place.process, nullptr, WNOHANG) != place.process)
    return false;
  place.process = -1;
  const bool at_once = Clock::now() - place.started < kAtOnce;
  place.pause = at_once ? std::clamp(place.pause * 2, kFirstPause, kLongestPause) : kFirstPause;
  place.again = Clock::now() + place.pause;
  return true;
}

void WorkerProcesses::start(Place& place) {
  std::vector<char*> words;
  words.reserve(command_.size() + 1);
  for (std::string& word : command_) words.push_back(word.data());
  words.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become_worker(words.data(), parent);
  place.started = Clock::now();
  place.again = place.started + kFirstPause;  // when there was no process to be had
  place.process = child;
}

void WorkerProcesses::ask_to_end() {
  ending_ = true;
  for (const pid_t process : running()) ::kill(process, SIGTERM);
}

bool WorkerProcesses::wait(std::chrono::milliseconds most) {
  constexpr std::chrono::milliseconds kLook{20};
  const auto end = Clock::now() + most;
  look_after();
  while (!running().empty() && Clock::now() < end) {
    std::this_thread::sleep_for(kLook);
    look_after();
  }
  return running().empty();
}

std::vector<pid_t> WorkerProcesses::running() const {
  std::vector<pid_t> out;
  for (const Place& place : places_)
    if (place.process > 0) out.push_back(place.process);
  return out;
}

}  // namespace regarment
