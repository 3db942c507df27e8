#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "jobs/job.h"

namespace regarment {

/// How far a command is, as it says with --progress json: {"stage": "fit", "fraction": 0.4,
/// "detail"?: "run 2, evaluation 40 of 500"}.
struct ProgressLine {
  std::string stage;
  double fraction = 0;  // of the stage, 0 to 1
  std::string detail;
};

/// Nothing for a line of another form.
std::optional<ProgressLine> parse_progress(std::string_view line);

/// Turns the stages of a command into one fraction of the whole job, which never goes back.
class JobProgress {
 public:
  explicit JobProgress(JobKind kind) : kind_(kind) {}

  /// The fraction once this was said, 0 to 1.
  double after(const ProgressLine& line);

 private:
  JobKind kind_;
  double reached_ = 0;
};

}  // namespace regarment
