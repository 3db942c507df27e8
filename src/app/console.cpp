#include "app/console.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

// False when the reader went away or the place is full; errno tells which.
bool put(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Console::Console(const Speech& speech, const StopSignal& stop)
    : speech_(speech), stop_(stop), terminal_(::isatty(STDERR_FILENO) != 0) {}

Console::~Console() { clear_bar(); }

Progress Console::progress() {
  return Progress([this](std::string_view stage, double fraction, std::string_view detail) {
    if (!speech_.quiet) {
      if (speech_.progress == "json") {
        show_json(stage, fraction, detail);
      } else if (terminal_) {
        show_bar(stage, fraction, detail);
      } else {
        show_line(stage, fraction, detail);
      }
    }
    return !stop_.asked();
  });
}

// Off a terminal a stage is told once it is over, so that a run that fails at once says one line.
void Console::show_line(std::string_view stage, double fraction, std::string_view detail) {
  if (stage != stage_) {
    if (!stage_.empty()) (void)put(STDERR_FILENO, stage_ + "\n");
    stage_ = stage, tenth_ = 0;
  }
  const int tenth = static_cast<int>(10 * std::clamp(fraction, 0.0, 1.0));
  if (!detail.empty() && tenth > tenth_) {
    tenth_ = tenth;
    (void)put(STDERR_FILENO, stage_ + ": " + std::string(detail) + "\n");
  }
  if (fraction < 1.0) return;
  (void)put(STDERR_FILENO, stage_ + "\n");
  stage_.clear();
}

void Console::show_json(std::string_view stage, double fraction, std::string_view detail) {
  const double share = std::clamp(fraction, 0.0, 1.0);
  const int percent = static_cast<int>(100 * share);
  if (stage == stage_ && percent == percent_) return;
  stage_ = stage, percent_ = percent;
  nlohmann::ordered_json json = {{"stage", stage_}, {"fraction", share}};
  if (!detail.empty()) json["detail"] = detail;
  (void)put(STDERR_FILENO,
            json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void Console::show_bar(std::string_view stage, double fraction, std::string_view detail) {
  constexpr int kWidth = 30;
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (stage == stage_ && percent == percent_ && detail == detail_) return;
  stage_ = stage;
  detail_ = detail;
  percent_ = percent;
  const auto full = static_cast<std::size_t>(kWidth * percent / 100);
  // Progress nobody reads is no failure.
  (void)put(STDERR_FILENO, "\r\x1b[K" + std::string(full, '#') + std::string(kWidth - full, '.') +
                               " " + stage_ + (detail_.empty() ? "" : ": " + detail_));
}

void Console::clear_bar() {
  if (terminal_ && percent_ >= 0 && speech_.progress != "json")
    (void)put(STDERR_FILENO, "\r\x1b[K");
  percent_ = -1;
}

void Console::say(std::string_view line) const {
  if (!speech_.quiet && !speech_.json) answer(std::string(line) + "\n");
}

void Console::complain(std::string_view line) {
  clear_bar();
  (void)put(STDERR_FILENO, "regarment: " + one_line(line, 2000) + "\n");
}

void Console::answer(std::string_view text) {
  if (put(STDOUT_FILENO, text) || errno == EPIPE) return;
  throw TemporaryError(std::string("standard output: cannot be written (") + std::strerror(errno) +
                       "); send it elsewhere");
}

}  // namespace regarment
