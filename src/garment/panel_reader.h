#pragma once

#include <array>
#include <string>

#include "garment/json_node.h"
#include "garment/template_data.h"

namespace regarment {

/// A formula from a text or a number; every name in it must already be known to `data`.
Formula read_formula(const JsonNode& node, const TemplateData& data);
std::array<Formula, 2> read_point(const JsonNode& node, const TemplateData& data);

/// Limbs a panel can wrap and an edge can go round.
std::string read_limb(const JsonNode& node);

/// Reads panels, panel_order, stitches and free_edges into `data`, whose dimensions, constants and
/// derived names are already there. Every edge must be sewn once or be a free edge.
void read_pattern(const JsonNode& pattern, const JsonNode& free_edges, TemplateData& data);

}  // namespace regarment
