#pragma once

#include <string>

#include "garment/garment_template.h"

namespace regarment {

enum class PatternStyle {
  Pattern,  // in real size, to be cut by: codes and lengths at the arrows, a table, a scale bar
  Sketch,   // to be read beside a table: large text, arrows with the letters A, B, ... of the
            // dimensions in the template's order and their lengths, and nothing else
};

struct PatternDrawingOptions {
  // A file of its own: XML declaration, dark ink on white. Otherwise for inlining into a page,
  // whose text colour it takes over (currentColor) and which may set the CSS variable --rp-accent
  // for the measurement arrows.
  bool standalone = true;
  PatternStyle style = PatternStyle::Pattern;
};

/// The letter of a template's dimension number `index` beside the arrows of a sketch: A, B, ...
std::string dimension_letter(std::size_t index);

/// The flat pattern in real size (SVG text; one user unit is one millimetre): every distinct piece
/// side by side with its outline, seams inside it dashed, centre line, construction lines,
/// notches, grain line, and an arrow per measurement with code, title and length; below, a table of
/// the measurements, a scale bar of 10 cm and what is to be cut. That is PatternStyle::Pattern; a
/// sketch has less. CSS classes begin with "rp-". Same input, same bytes. Throws InvalidInput when
/// `dimensions` make no garment.
std::string pattern_svg(const GarmentTemplate& garment, const Dimensions& dimensions,
                        const PatternDrawingOptions& options = {});

}  // namespace regarment
