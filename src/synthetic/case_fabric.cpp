#include "synthetic/case_fabric.h"

#include <algorithm>
#include <array>

namespace regarment {
namespace {

struct Range {
  double low, high;
};

// A kind of cloth, in the units of SheetFabric. Stiffness and bending follow published tests of
// apparel fabrics (KES-F: tensile 100 to 4000 N/m, bending 2e-6 to 4e-4 N m) in round figures.
struct Cloth {
  double share;
  Range thickness, density, along, across, shear, bending;
};

constexpr std::array<Cloth, 4> kCloths = {
    Cloth{0.35, {6e-4, 1.2e-3}, {0.12, 0.2}, {300, 900}, {200, 600}, {60, 200}, {2e-6, 1e-5}},
    Cloth{0.35, {6e-4, 1.5e-3}, {0.12, 0.28}, {1500, 4000}, {1200, 3000}, {200, 500}, {8e-6, 6e-5}},
    Cloth{0.2, {1.5e-3, 3e-3}, {0.28, 0.45}, {2500, 5000}, {2000, 4000}, {300, 800}, {5e-5, 2e-4}},
    Cloth{0.1, {3e-3, 5e-3}, {0.25, 0.45}, {600, 2000}, {500, 1500}, {150, 500}, {8e-5, 4e-4}}};

double draw(const Range& range, CaseDice& dice) { return dice.uniform(range.low, range.high); }

// Evenly by order of magnitude.
double draw_magnitude(const Range& range, CaseDice& dice) {
  return std::exp(dice.uniform(std::log(range.low), std::log(range.high)));
}

}  // namespace

SheetFabric sample_fabric(double thick, double thickest, CaseDice& dice) {
  std::size_t kind = 0;
  while (kind + 1 < kCloths.size() && thick >= kCloths[kind].share) thick -= kCloths[kind++].share;
  const Cloth& cloth = kCloths[kind];
  SheetFabric out;
  out.thickness = std::min(draw(cloth.thickness, dice), thickest);
  out.density = draw(cloth.density, dice);
  out.stiffness_along = draw(cloth.along, dice);
  out.stiffness_across = draw(cloth.across, dice);
  out.stiffness_shear = draw(cloth.shear, dice);
  out.bending = draw_magnitude(cloth.bending, dice);
  out.friction = dice.uniform(0.2, 0.5);
  return out;
}

}  // namespace regarment
