#pragma once

#include <string>

namespace regarment {

/// Checks that a stored drawing is one the program may put into a page as it stands: SVG of shapes
/// and text, no scripts, links, animation, foreign content or entities of its own. Throws ReadError
/// naming the file and what it found.
void check_drawing(const std::string& svg, const std::string& name_for_messages);

}  // namespace regarment
