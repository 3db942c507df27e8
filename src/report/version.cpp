#include "report/version.h"

namespace regarment {

std::string version() { return REGARMENT_VERSION; }

}  // namespace regarment
