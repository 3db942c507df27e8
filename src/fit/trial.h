#pragma once

#include <vector>

#include "drape/drape.h"
#include "fit/fit_target.h"
#include "fit/fit_trace.h"
#include "garment/garment_template.h"
#include "garment/pattern.h"
#include "render/silhouette.h"

namespace regarment {

/// One garment that is draped again and again with other dimensions. Keeps where the cloth lay
/// last: the next drape starts there, only rest lengths and masses change [Hasler et al. 2007,
/// sec. 3.1]. Draws with the context of its thread: make and use it in one thread.
class Trial {
 public:
  /// Borrows `garment`, `target` and `held`. `placed`: one position per vertex of `pattern`, body
  /// frame, m.
  Trial(const GarmentTemplate& garment, const Pattern& pattern, const std::vector<Vec3>& placed,
        const FitTarget& target, const std::vector<HeldEdge>& held, const DrapeOptions& options);

  /// Drapes the garment at these dimensions, which must make a garment, and judges it by the terms
  /// of Eq. (1). Cloth that has slid out of the pictures has the `unseen_error`. Throws as `drape`
  /// does.
  ErrorTerms judge(const Dimensions& dimensions, const Progress& progress = {});

  /// Puts the particles there; the next drape starts from them.
  void start_from(const std::vector<Vec3>& particles) { cloth_.positions = particles; }

  const DrapeOutcome& outcome() const { return outcome_; }  // of the last judge()
  const Cloth& cloth() const { return cloth_; }

 private:
  const GarmentTemplate& garment_;
  const FitTarget& target_;
  const std::vector<HeldEdge>& held_;
  DrapeOptions options_;
  Pattern pattern_;
  Cloth cloth_;
  DrapeOutcome outcome_;
  SilhouetteRenderer renderer_;
};

}  // namespace regarment
