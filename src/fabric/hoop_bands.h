#pragma once

#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "garment/pattern.h"

namespace regarment {

/// A strip of cloth round a limb.
struct HoopBand {
  double position = 0;        // m across the strips, from the first dimension's line
  double girth = 0;           // m, about, of the flat pattern
  double excess = 0;          // log of the strip's length as it lies over that of the pattern
  double fold = 0;            // log of its length over a tape's pulled tight round it, >= 0
  std::vector<double> share;  // d log(flat length) / d log(dimension), one per dimension
};

/// Strips side by side over the panels of one limb, from the garment's one end to the other.
struct HoopFamily {
  std::vector<std::string> dimensions;  // circumferences that these strips' lengths depend on
  std::vector<double> folds;            // of the strip at each one's line; 0 without such a line
  std::vector<HoopBand> bands;
};

/// Cuts the garment into strips 2 cm wide along the lines of its circumferences. `pattern` is flat
/// at `worn`, dimensions as they lie on the body; `draped` has one position per pattern vertex, m.
/// So excess is 0 where a dimension is measured, if cloth and dimensions agree, and
///
///   strain of a strip = excess + sum over dimensions of share * log(worn / flat dimension)
///
/// which cannot be below 0 for long: cloth that is pushed together folds, and the strip follows the
/// folds. Left and right, front and back count together. Strips that end at a seam to another limb
/// (beside a sleeve) are left out. `names`: the dimensions whose lines give the direction of
/// strips; `others`: those that may change their length besides.
std::vector<HoopFamily> hoop_families(const GarmentTemplate& garment, const Dimensions& worn,
                                      const Pattern& pattern, const std::vector<Vec3>& draped,
                                      const std::vector<std::string>& names,
                                      const std::vector<std::string>& others);

}  // namespace regarment
