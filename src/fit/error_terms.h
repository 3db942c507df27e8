#pragma once

#include <span>

#include "fit/fit_trace.h"
#include "render/silhouette.h"

namespace regarment {

/// Eq. (1): alpha E_dist + beta sqrt|1 - E_stretch| + gamma E_sil. `square_root` false leaves the
/// root out, to see what it does.
double total_error(const ErrorTerms& terms, const ErrorWeights& weights, bool square_root = true);

/// E_sil: for each side the pixels in which the silhouettes of model and garment differ over those
/// of the garment, summed. Throws InvalidInput when the counts or sizes differ, and NoGarmentError
/// when a silhouette of the garment is empty.
double silhouette_error(std::span<const Silhouette> model, std::span<const Silhouette> garment);

/// E_sil of a garment that is not seen: the largest that one seen from every side can have, which
/// shows a single pixel beside the model.
double unseen_error(std::span<const Silhouette> model);

}  // namespace regarment
