#include "synthetic/scanner_options.h"

#include <sstream>

#include "base/error.h"

namespace regarment {

void check_scanner_value(std::string_view name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  std::ostringstream text;
  text << "scanner " << name << " is " << value << ", it must be " << low << " to " << high;
  throw InvalidInput(text.str());
}

}  // namespace regarment
