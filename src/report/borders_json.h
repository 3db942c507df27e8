#pragma once

#include <string>

#include "analysis/analysis.h"

namespace regarment {

/// borders.json: the lines along which the labels of garments end, closed, in the frame and unit of
/// the scan's file; the first point is not repeated. `shown` is the share of a line beside which
/// the label does end; the rest bridges holes and what other garments cover.
std::string borders_json(const Analysis& analysis);

}  // namespace regarment
