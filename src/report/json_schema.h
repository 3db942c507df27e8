#pragma once

#include <string>

namespace regarment {

/// Checks a text against schemas/result.schema.json, which is compiled in. Throws ReadError naming
/// the place ("/garments/0/measurements/2/value_cm") and what is wrong; also when the text is no
/// JSON, nests deeper than 64 levels, or has one key twice in an object.
void check_by_result_schema(const std::string& json, const std::string& name_for_messages);

}  // namespace regarment
