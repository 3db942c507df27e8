#pragma once

#include <span>

#include "fit/fit_trace.h"

namespace regarment {

/// Alpha, beta and gamma such that the three terms of Eq. (1) are of the same order of magnitude
/// over `samples`: alpha is 1, the others bring the medians of their terms to that of E_dist
/// [Hasler et al. 2007, sec. 3.3]. A term that is zero in most samples keeps the weight that one
/// percent of stretch, or a hundredth of E_sil, would have. `square_root`: as in
/// total_error. Throws InvalidInput without samples.
ErrorWeights balance(std::span<const ErrorTerms> samples, bool square_root = true);

}  // namespace regarment
