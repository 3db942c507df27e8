#pragma once

#include <string>
#include <string_view>

#include "app/command_line.h"
#include "app/stop_signal.h"
#include "base/progress.h"

namespace regarment {

/// Where the program speaks: results on standard output, progress on standard error.
class Console {
 public:
  Console(const Speech& speech, const StopSignal& stop);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Draws a bar on a terminal; elsewhere writes a line for each stage done and for each tenth of a
  /// stage that has something to say, or, with --progress json, {"stage", "fraction", "detail"?}
  /// for each percent of a stage; says nothing when quiet; answers "stop" once a signal came. Lives
  /// no longer than the console.
  Progress progress();

  /// A line for a person on standard output; silent when quiet or when the result goes there as
  /// JSON.
  void say(std::string_view line) const;

  /// A failure that is not the last, as the one line `main` would make of it; never silent.
  void complain(std::string_view line);

  /// The result on standard output, as it is. Throws TemporaryError when it cannot be written; a
  /// reader that went away has had what it wanted and is no failure.
  static void answer(std::string_view text);

  bool wants_json() const { return speech_.json; }

 private:
  void show_line(std::string_view stage, double fraction, std::string_view detail);
  void show_json(std::string_view stage, double fraction, std::string_view detail);
  void show_bar(std::string_view stage, double fraction, std::string_view detail);
  void clear_bar();

  Speech speech_;
  const StopSignal& stop_;
  bool terminal_;
  std::string stage_;
  std::string detail_;
  int percent_ = -1;
  int tenth_ = 0;  // of the stage, last told off a terminal
};

}  // namespace regarment
