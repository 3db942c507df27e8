#pragma once

#include <string>

namespace regarment {

/// The text of a file of service_pages/, compiled into the program, by its name. Throws
/// InvalidInput when there is none.
const std::string& page_text(const std::string& name);

}  // namespace regarment
