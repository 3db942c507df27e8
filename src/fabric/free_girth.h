#pragma once

#include <map>
#include <string>
#include <vector>

#include "fabric/explain_bands.h"
#include "garment/garment_template.h"
#include "garment/pattern.h"

namespace regarment {

/// A circumference read where its cloth hangs free.
struct FreeGirth {
  double length = 0;  // m, as worn
  double loose = 0;   // 0..1, how likely that cloth is not stretched, by its folds
};

/// Dimensions that cloth beside their own line tells of as well: where the sides run straight on
/// from the line of a chest down to the hem, every strip is as long as that line when flat. Folds
/// hide cloth in the armpits, where the line is; less of it the farther the strip is from them. So
/// the strips of the farther third count, but for the last, whose edge may roll or stand out.
///
/// `worn`, `pattern` and `draped` as for worn_stretch. Has no entry for a dimension whose line no
/// such strips run beside. Throws InvalidInput like hoop_families.
std::map<std::string, FreeGirth> free_girths(const GarmentTemplate& garment, const Dimensions& worn,
                                             const Pattern& pattern,
                                             const std::vector<Vec3>& draped);

/// The stretch of a dimension read there, `here` being that at its own line.
Stretch where_free(const Stretch& here, const FreeGirth& free);

}  // namespace regarment
