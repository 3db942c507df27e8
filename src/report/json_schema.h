#pragma once

#include <string>

namespace regarment {

/// Checks a text against a schema of schemas/, which are compiled in; `schema` is the name of its
/// file. Throws ReadError naming the place ("/garments/0/measurements/2/value_cm"), what is wrong
/// and the `advice`; also when the text is no JSON, nests deeper than 64 levels, or has one key
/// twice in an object.
void check_by_schema(const std::string& json, const std::string& schema,
                     const std::string& name_for_messages, const std::string& advice);

/// The same for a result.json.
void check_by_result_schema(const std::string& json, const std::string& name_for_messages);

}  // namespace regarment
