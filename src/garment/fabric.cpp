#include "garment/fabric.h"

#include <array>
#include <utility>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

constexpr std::array<std::pair<Fabric, std::string_view>, 4> kFabrics = {{
    {Fabric::Unknown, "unknown"},
    {Fabric::Woven, "woven"},
    {Fabric::Jersey, "jersey"},
    {Fabric::Elastic, "elastic"},
}};

}  // namespace

std::string_view fabric_name(Fabric fabric) {
  for (const auto& [known, name] : kFabrics)
    if (known == fabric) return name;
  throw InvalidInput("fabric_name: no fabric of this value");
}

Fabric fabric_named(const std::string& name) {
  for (const auto& [fabric, known] : kFabrics)
    if (known == name) return fabric;
  throw UsageError("--fabric: '" + one_line(name, 60) +
                   "' is unknown; use woven, jersey or elastic");
}

}  // namespace regarment
