#include "garment/hold_dimensions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/random.h"
#include "garment/template_check.h"
#include "garment/template_data.h"

namespace regarment {
namespace {

constexpr int kDraws = 2000;   // of other dimensions, further and further from those wanted
constexpr int kHalvings = 10;  // 1/1024 of the way back from the draw that can be made

Dimensions with(Dimensions dimensions, const Dimensions& held) {
  for (const auto& [name, value] : held) dimensions[name] = value;
  return dimensions;
}

bool possible(const GarmentTemplate& garment, const Dimensions& dimensions) {
  return !why_impossible(garment.data(), dimensions);
}

/// Each dimension within its bounds; finite values near them are moved there.
Dimensions bounded(const GarmentTemplate& garment, const Dimensions& wanted) {
  Dimensions out = garment.typical();
  for (const Dimension& d : garment.dimensions()) {
    const auto given = wanted.find(d.name);
    if (given != wanted.end() && std::isfinite(given->second))
      out[d.name] = std::clamp(given->second, d.lower, d.upper);
  }
  return out;
}

/// Some garment that can be made: the typical one, or the first of draws round `centre`.
std::optional<Dimensions> some_garment(const GarmentTemplate& garment, const Dimensions& centre,
                                       const Dimensions& held) {
  if (Dimensions typical = with(garment.typical(), held); possible(garment, typical))
    return typical;
  Random random(1);
  for (int i = 1; i <= kDraws; ++i) {
    const double share = static_cast<double>(i) / kDraws;
    Dimensions drawn = centre;
    for (const Dimension& d : garment.dimensions()) {
      const double reach = share * (d.upper - d.lower);
      drawn[d.name] =
          std::clamp(drawn.at(d.name) + random.uniform(-reach, reach), d.lower, d.upper);
    }
    drawn = with(std::move(drawn), held);
    if (possible(garment, drawn)) return drawn;
  }
  return std::nullopt;
}

/// Unknown names and values out of bounds, in the words of the template's own check.
void check_held(const GarmentTemplate& garment, const Dimensions& held) {
  const bool fine = std::all_of(held.begin(), held.end(), [&](const auto& one) {
    return std::any_of(
        garment.dimensions().begin(), garment.dimensions().end(), [&](const Dimension& d) {
          return d.name == one.first && one.second >= d.lower && one.second <= d.upper;
        });
  });
  if (!fine) garment.check(with(garment.typical(), held));
}

}  // namespace

Dimensions nearest_holding(const GarmentTemplate& garment, const Dimensions& wanted,
                           const Dimensions& held) {
  if (held.empty()) return garment.nearest_possible(wanted);
  check_held(garment, held);
  Dimensions nearest = with(bounded(garment, wanted), held);
  if (possible(garment, nearest)) return nearest;
  const auto safe = some_garment(garment, nearest, held);
  if (!safe)
    throw UsageError(garment.name() + ": no garment has the dimensions that are fixed: " +
                     *why_impossible(garment.data(), nearest));
  const auto between = [&](double share) {
    Dimensions mixed = nearest;
    for (auto& [name, value] : mixed) value += share * (safe->at(name) - value);
    return with(std::move(mixed), held);
  };
  double impossible = 0.0, reached = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (impossible + reached) / 2.0;
    (possible(garment, between(middle)) ? reached : impossible) = middle;
  }
  return reached == 1.0 ? *safe : between(reached);
}

}  // namespace regarment
