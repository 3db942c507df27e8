#pragma once

#include <vector>

#include "base/random.h"
#include "geometry/mesh.h"
#include "synthetic/dressed_person.h"

namespace regarment {

/// The colour of a garment.
struct ClothColour {
  Colour colour = {90, 110, 160};
  double stripe = 0.0;  // m, 0 .. 0.2: width of stripes down the panel; 0: none
  Colour second = {210, 210, 205};
};

/// Colours as a scanner with even light sees them.
struct ColourOptions {
  bool coloured = true;  // false: points have no colours
  Colour skin = {214, 168, 140};
  Colour hair = {70, 50, 38};
  std::vector<ClothColour> garments;  // outermost first; missing ones as ClothColour is
  // 0 .. 1: how far the garments' colours have moved to the skin's. 1: colour tells nothing.
  double alike = 0.0;
  double noise = 6.0;  // 0 .. 60, standard deviation per channel, of 255

  void check() const;  // throws InvalidInput naming the field and its value
};

/// A point of a scene that is to be coloured.
struct ColouredPlace {
  std::uint8_t owner = 0;   // as in ScannerScene
  Vec3 position;            // body frame, m
  double down_panel = 0.0;  // m, flat t; of a garment
};

/// Colour of a place: of a garment its own; of the person skin, or hair on the back and top of the
/// head; grey for what is nobody's. `top` is the highest point of the head.
Colour colour_of(const ColouredPlace& place, const Vec3& top, const ColourOptions& options,
                 Random& random);

}  // namespace regarment
