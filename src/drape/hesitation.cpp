#include "drape/hesitation.h"

#include <utility>

namespace regarment {
namespace {

constexpr double kDoubt = 0.5;  // of the weight is left after a jump
// A target moves along with its particle; on curved or rough surfaces it may move some times as
// far, and by the distance between the points of a cloud, m.
constexpr double kLead = 3.0, kSpacing = 0.01;

bool jumped(const Attraction& before, const Attraction& now, double moved) {
  if (before.pulls != now.pulls) return true;
  return now.pulls && (now.target - before.target).norm() > kLead * moved + kSpacing;
}

}  // namespace

Hesitation::Hesitation(std::vector<Vec3> positions, std::vector<Attraction> targets)
    : last_positions_(std::move(positions)), last_(std::move(targets)) {}

void Hesitation::weigh(const std::vector<Vec3>& positions, std::vector<Attraction>& targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double moved = (positions[i] - last_positions_[i]).norm();
    targets[i].weight = last_[i].weight * (jumped(last_[i], targets[i], moved) ? kDoubt : 1);
  }
  last_positions_ = positions;
  last_ = targets;
}

}  // namespace regarment
