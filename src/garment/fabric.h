#pragma once

#include <string>
#include <string_view>

namespace regarment {

/// What a garment is made of, as far as a person can tell: how much longer tight cloth is worn than
/// it lies flat.
enum class Fabric {
  Unknown,  // any of the others
  Woven,    // hardly stretches
  Jersey,   // knitted: gives under weight and over the body
  Elastic,  // made to stretch: an elastic waist, ribs, elastane
};

/// "unknown", "woven", "jersey", "elastic".
std::string_view fabric_name(Fabric fabric);

/// The fabric of that name. Throws UsageError naming those there are.
Fabric fabric_named(const std::string& name);

}  // namespace regarment
