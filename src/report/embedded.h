#pragma once

#include <string>

namespace regarment {

/// The text of a file of report_templates/ or schemas/, compiled into the program, by its name
/// without folder. Throws InvalidInput when there is none.
const std::string& embedded_text(const std::string& name);

}  // namespace regarment
