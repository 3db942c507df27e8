#pragma once

#include <optional>
#include <string>
#include <vector>

#include "garment/shape_mesh.h"
#include "garment/template_data.h"

namespace regarment {

/// Checks the geometry of a template that was just read and fills in its coarse triangulation:
/// outlines that do not cross themselves, lines and points inside, seams of equal length, a sewn
/// surface whose free edges are closed loops. What depends on dimensions is checked at typical
/// dimensions and at the corners of the bounds (all corners up to eight dimensions, else one
/// dimension at a time), leaving out those that the template's own `requires` forbids.
/// Throws ReadError("FILE: /json/pointer: ...").
void check_geometry(TemplateData& data);

/// Why these dimensions, all given and finite, make no garment: an unmet requirement with the
/// dimensions it speaks of, or a panel that would fold over itself. Nothing when they do make one.
std::optional<std::string> why_impossible(const TemplateData& data, const Dimensions& dimensions);

/// "width 104.0 cm"
std::string dimension_text(const Dimension& dimension, double value);

/// Frame of every shape, from the checked template.
std::vector<ShapeFrame> shape_frames(const TemplateData& data);

}  // namespace regarment
