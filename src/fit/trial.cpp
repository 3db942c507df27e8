#include "fit/trial.h"

#include <algorithm>

#include "fit/error_terms.h"

namespace regarment {
namespace {

/// One trial that slides out of the pictures must not end the search.
double silhouette_term(std::span<const Silhouette> model, std::span<const Silhouette> garment) {
  const bool seen = std::all_of(garment.begin(), garment.end(),
                                [](const Silhouette& side) { return side.area() > 0; });
  return seen ? silhouette_error(model, garment) : unseen_error(model);
}

}  // namespace

Trial::Trial(const GarmentTemplate& garment, const Pattern& pattern,
             const std::vector<Vec3>& placed, const FitTarget& target,
             const std::vector<HeldEdge>& held, const DrapeOptions& options)
    : garment_(garment),
      target_(target),
      held_(held),
      options_(options),
      pattern_(pattern),
      cloth_(make_cloth(pattern, placed)),
      renderer_(cloth_.triangles, cloth_.size(), target.silhouettes().front().size) {}

ErrorTerms Trial::judge(const Dimensions& dimensions, const Progress& progress) {
  move_pattern(garment_, dimensions, pattern_);
  update_cloth(pattern_, cloth_);
  std::fill(cloth_.velocities.begin(), cloth_.velocities.end(), Vec3::Zero());
  outcome_ = drape(cloth_, target_.surface(), options_, progress, held_, target_.shares());
  const std::vector<Silhouette> seen = renderer_.draw(cloth_.positions, target_.cameras());
  return {outcome_.mean_distance, outcome_.mean_stretch,
          silhouette_term(target_.silhouettes(), seen)};
}

}  // namespace regarment
