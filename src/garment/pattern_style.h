#pragma once

#include <string>

namespace regarment {

/// The CSS of a drawn pattern. Internal to this library. `standalone`: a file of its own, dark on
/// white and without CSS variables, which drawing programs do not know; otherwise for inlining into
/// a page, as PatternDrawingOptions says.
std::string pattern_style(bool standalone);

}  // namespace regarment
