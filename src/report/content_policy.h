#pragma once

#include <string>
#include <string_view>

namespace regarment {

/// The Content-Security-Policy of a page that holds one style and one script element with exactly
/// these texts and pictures as data: it lets these run by their SHA-256 and nothing else, and
/// forbids every request.
std::string content_policy(std::string_view style, std::string_view script);

}  // namespace regarment
