// Any text as a garment template: ReadError, or a template that can be used.
#include <cstdint>
#include <string>

#include "base/error.h"
#include "garment/garment_template.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto garment = regarment::GarmentTemplate::parse(text, "input");
    garment.check(garment.typical());
    for (const auto& observation : garment.observations()) {
      garment.evaluate(observation.equals, garment.typical());
    }
  } catch (const regarment::ReadError&) {
  }
  return 0;
}
