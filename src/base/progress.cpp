#include "base/progress.h"

#include "base/error.h"

namespace regarment {

void Progress::report(std::string_view stage, double fraction) const {
  if (callback_ && !callback_(stage, fraction)) throw Stopped();
}

}  // namespace regarment
