#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "http/response.h"

namespace regarment {

/// A file of a result folder, for the segments that a client named. Pages get a policy under which
/// their own scripts run and nothing else. Throws HttpProblem 404 "no_such_file".
Response result_file(const Request& request, const std::filesystem::path& folder,
                     const std::vector<std::string>& segments);

/// The media type by the end of a name; application/octet-stream when it says nothing.
std::string media_type(const std::string& name);

}  // namespace regarment
