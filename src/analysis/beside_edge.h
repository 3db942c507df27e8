#pragma once

#include <optional>

#include "analysis/analysis.h"

namespace regarment {

/// How far beyond an edge of a garment the person is measured beside it, m: clear of folds, facings
/// and labels that are off by a few millimetres.
inline constexpr double kBesideEdge = 0.02;

/// The girth of what the person shows 2 cm beyond a garment's edge (above a waist, past a cuff),
/// bare or dressed in something else that carries no garment's label, m. Laid in the edge's mean
/// plane. Nothing where it is not seen all round: another garment covers it, more than a tenth of
/// it is a gap, it comes apart (two legs below a hem), or the outline is much longer than the edge
/// (it took in an arm or a hand).
std::optional<double> girth_beside(const Analysis& analysis, const GarmentAnalysis& garment,
                                   const EdgeCurve& edge);

}  // namespace regarment
