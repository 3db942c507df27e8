#pragma once

#include <string>

#include "report/result.h"

namespace regarment {

/// The sizes of the garments as schema.org has them (JSON-LD): per garment a Product whose size is
/// a SizeSpecification with a QuantitativeValue in centimetres per measurement, the interval as its
/// bounds, and what WearableMeasurementTypeEnumeration calls it where it has a word. What the scan
/// does not show is left out. Without '<', so that it may stand in a script element.
std::string size_json_ld(const Result& result);

}  // namespace regarment
