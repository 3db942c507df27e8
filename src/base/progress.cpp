#include "base/progress.h"

#include "base/error.h"

namespace regarment {

Progress::Progress(ProgressCallback callback) {
  if (!callback) return;
  callback_ = [told = std::move(callback)](std::string_view stage, double fraction,
                                           std::string_view) { return told(stage, fraction); };
}

void Progress::report(std::string_view stage, double fraction, std::string_view detail) const {
  if (callback_ && !callback_(stage, fraction, detail)) throw Stopped();
}

}  // namespace regarment
