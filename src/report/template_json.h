#pragma once

#include <string>

#include "garment/garment_template.h"

namespace regarment {

/// The templates there are as JSON: [{"name", "title", "source"}].
std::string templates_json();

/// A template as JSON: {"name", "title", "description", "dimensions": [{"name", "code", "title",
/// "definition", "how_to_measure", "circumference", "typical_cm", "bounds_cm"}], "sources"}.
std::string template_json(const GarmentTemplate& garment);

}  // namespace regarment
