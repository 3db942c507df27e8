#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace regarment {

/// Names of the files below `folder`, with "/" between, sorted; hidden ones and links are left out.
std::vector<std::string> file_names(const std::filesystem::path& folder);

/// Whether a name that came from outside may be one of these: at most 8 parts with "/" between,
/// each of 1 to 255 bytes, none of them a backslash or a control character, none beginning with a
/// dot.
bool is_file_name(std::string_view name);

}  // namespace regarment
