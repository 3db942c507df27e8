#pragma once

#include <string>
#include <string_view>

namespace regarment {

/// `text` fit for a one-line message: control characters and bytes outside printable ASCII that are
/// not valid UTF-8 become \xHH, and more than `most` bytes are cut with "..." at the end.
/// File names and tokens from files pass through here before they reach a message.
std::string one_line(std::string_view text, std::size_t most = 200);

}  // namespace regarment
