#include "fabric/free_girth.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "fabric/dimension_role.h"
#include "fabric/hoop_bands.h"
#include "fabric/stretch_prior.h"

namespace regarment {
namespace {

constexpr double kAlone = 0.97;  // share of a dimension in a strip as long as it, when flat
constexpr double kFrom = 0.65, kTo = 0.93;  // of the way from its line to the last strip
constexpr std::size_t kFewest = 3;          // strips

FreeGirth girth_of(const HoopFamily& family, std::size_t dimension, double worn) {
  double last = 0;
  for (const HoopBand& band : family.bands)
    if (band.share[dimension] > kAlone) last = std::max(last, std::abs(band.position));
  std::vector<double> folds;
  double sum = 0;
  for (const HoopBand& band : family.bands) {
    const double way = std::abs(band.position) / last;
    if (band.share[dimension] < kAlone || way < kFrom || way > kTo) continue;
    folds.push_back(band.fold);
    sum += worn * std::exp(band.excess);
  }
  if (folds.size() < kFewest) return {};
  return {sum / static_cast<double>(folds.size()), 1 - tight_share(median(folds))};
}

constexpr double kFreeStretch = 0.0015;  // of cloth that hangs free

}  // namespace

Stretch where_free(const Stretch& here, const FreeGirth& free) {
  return {here.mean + free.loose * (kFreeStretch - here.mean), here.standard_deviation};
}

std::map<std::string, FreeGirth> free_girths(const GarmentTemplate& garment, const Dimensions& worn,
                                             const Pattern& pattern,
                                             const std::vector<Vec3>& draped) {
  std::vector<std::string> hoops;
  for (const Dimension& d : garment.dimensions())
    if (dimension_role(garment, worn, pattern, d.name) == DimensionRole::Hoop)
      hoops.push_back(d.name);
  std::map<std::string, FreeGirth> out;
  for (const HoopFamily& family : hoop_families(garment, worn, pattern, draped, hoops, {}))
    for (std::size_t d = 0; d < family.dimensions.size(); ++d)
      if (const FreeGirth girth = girth_of(family, d, worn.at(family.dimensions[d]));
          girth.length > 0)
        out[family.dimensions[d]] = girth;
  return out;
}

}  // namespace regarment
