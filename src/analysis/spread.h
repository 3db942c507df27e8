#pragma once

#include "analysis/analysis.h"

namespace regarment {

/// What was found on `whole.thin`, for all vertices of the scan itself: each has the label, the
/// probability and the deviation of the vertex that stands for it, each triangle is a cap where its
/// corners' are. Vertices that are no numbers are the person's, and sure. Findings are passed on.
Analysis spread_over(Analysis of_thin, Scan whole);

}  // namespace regarment
