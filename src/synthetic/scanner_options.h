#pragma once

#include <string_view>

namespace regarment {

/// Throws InvalidInput "scanner NAME is VALUE, it must be LOW to HIGH" unless it is.
void check_scanner_value(std::string_view name, double value, double low, double high);

}  // namespace regarment
