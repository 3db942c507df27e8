#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/evaluated_scan.h"
#include "geometry/mesh.h"

namespace regarment {

/// What the label of a vertex came to.
enum class Confusion { RightPerson, RightGarment, Missed, Wrong, NotScored };

/// Missed: a garment's vertex labelled person. Wrong: a vertex labelled as a garment that is not
/// there, be it the person's or another garment's.
Confusion confusion_of(std::uint8_t label, std::uint8_t truth);

/// Its colour: told apart also by those who do not see red and green, or in grey.
Colour confusion_colour(Confusion confusion);

/// A small WebP of the scan from the front and from behind, each vertex in its confusion's colour.
struct DrawnConfusion {
  std::string webp;
  int width = 0, height = 0;
};

/// Draws what the fit in `folder` labelled. The scan has true labels. Throws ReadError when a file
/// is not what it should be, NoPersonError when the scan stands nowhere.
DrawnConfusion draw_confusion(const EvaluationCase& about, const std::filesystem::path& folder);

}  // namespace regarment
