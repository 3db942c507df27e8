#pragma once

#include <array>
#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "garment/pattern.h"

namespace regarment {

/// A straight line across one flat panel, (s, t), m.
struct PanelLine {
  int panel = 0;
  Vec2 from, to;
};

/// Where a dimension is measured on the flat garment: the line of the template's drawing, on every
/// panel that holds it whole, left and right, front and back. Throws InvalidInput for a dimension
/// the template does not draw.
std::vector<PanelLine> dimension_lines(const GarmentTemplate& garment, const Pattern& pattern,
                                       const Dimensions& dimensions, const std::string& name);

/// How much longer a line is on the worn garment than it is flat, following the cloth triangle by
/// triangle: 1 is as long. `particles` as in WornGarment.
double stretch_along(const Pattern& pattern, const std::vector<Vec3>& particles,
                     const PanelLine& line);

/// Particles within `distance` metres of a line in its panel, ascending.
std::vector<int> particles_beside(const Pattern& pattern, const PanelLine& line, double distance);

}  // namespace regarment
