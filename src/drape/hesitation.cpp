#include "drape/hesitation.h"

#include <utility>

namespace regarment {
namespace {

constexpr double kDoubt = 0.5;  // of the weight is left
// A target moves along with its particle; on curved or rough surfaces it may move some times as
// far, and by the distance between the points of a cloud, m.
constexpr double kLead = 3.0, kSpacing = 0.01;
// The first steps of a drape overshoot and come back; later a particle that turns back after
// having moved this far, m, does not know where to go.
constexpr int kFirstSteps = 4;
constexpr double kTurn = 0.0025;

bool jumped(const Attraction& before, const Attraction& now, double moved) {
  if (before.pulls != now.pulls) return true;
  return now.pulls && (now.target - before.target).norm() > kLead * moved + kSpacing;
}

bool turned_back(const Vec3& before, const Vec3& now) {
  return now.dot(before) < 0 && now.norm() > kTurn && before.norm() > kTurn;
}

}  // namespace

Hesitation::Hesitation(std::vector<Vec3> positions, std::vector<Attraction> targets)
    : positions_(std::move(positions)),
      moves_(positions_.size(), Vec3::Zero()),
      targets_(std::move(targets)),
      doubted_(positions_.size(), 0) {}

void Hesitation::weigh(const std::vector<Vec3>& positions, std::vector<Attraction>& targets) {
  ++steps_;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Vec3 move = positions[i] - positions_[i];
    const bool hesitates = jumped(targets_[i], targets[i], move.norm()) ||
                           (steps_ > kFirstSteps && turned_back(moves_[i], move));
    targets[i].weight = targets_[i].weight * (hesitates && doubted_[i] != 0 ? kDoubt : 1);
    if (hesitates) doubted_[i] = 1;
    moves_[i] = move;
  }
  positions_ = positions;
  targets_ = targets;
}

}  // namespace regarment
