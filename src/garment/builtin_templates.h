#pragma once

#include <string_view>
#include <vector>

namespace regarment {

struct BuiltinTemplate {
  std::string_view name;
  std::string_view json;
};

/// The files of the source tree's templates folder, as they were when the program was built.
const std::vector<BuiltinTemplate>& builtin_templates();

}  // namespace regarment
