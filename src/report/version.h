#pragma once

#include <string>

namespace regarment {

/// The program's version as CMakeLists.txt states it: "0.1.0".
std::string version();

}  // namespace regarment
