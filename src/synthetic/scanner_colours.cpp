#include "synthetic/scanner_colours.h"

#include <algorithm>
#include <cmath>

#include "synthetic/scanner_options.h"
#include "synthetic/scanner_scene.h"

namespace regarment {
namespace {

constexpr Colour kProp = {128, 128, 126};

// The head is the upper eighth; hair grows on it above a line that falls from forehead to nape.
bool in_hair(const Vec3& p, const Vec3& top) {
  const double below = (top.y() - p.y()) / top.y(), ahead = (p.z() - top.z()) / top.y();
  return below < 0.12 && below < 0.04 - ahead;
}

Colour cloth(const ColouredPlace& place, const ColourOptions& options) {
  const std::size_t i = place.owner - 1U;
  const ClothColour own = i < options.garments.size() ? options.garments[i] : ClothColour{};
  const bool second =
      own.stripe > 0 && static_cast<long>(std::floor(place.down_panel / own.stripe)) % 2 != 0;
  Colour colour = second ? own.second : own.colour;
  for (std::size_t c = 0; c < colour.size(); ++c)
    colour[c] = static_cast<std::uint8_t>(
        std::lround((1 - options.alike) * colour[c] + options.alike * options.skin[c]));
  return colour;
}

}  // namespace

void ColourOptions::check() const {
  check_scanner_value("colours alike", alike, 0, 1);
  check_scanner_value("colour noise", noise, 0, 60);
  for (const ClothColour& own : garments) check_scanner_value("stripe", own.stripe, 0, 0.2);
}

Colour colour_of(const ColouredPlace& place, const Vec3& top, const ColourOptions& options,
                 Random& random) {
  Colour colour = in_hair(place.position, top) ? options.hair : options.skin;
  if (place.owner == kOwnerNobody)
    colour = kProp;
  else if (place.owner != kOwnerPerson)
    colour = cloth(place, options);
  for (std::uint8_t& channel : colour)
    channel = static_cast<std::uint8_t>(
        std::lround(std::clamp(channel + options.noise * random.normal(), 0.0, 255.0)));
  return colour;
}

}  // namespace regarment
