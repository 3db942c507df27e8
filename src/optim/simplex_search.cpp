#include "optim/simplex_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace regarment {

using Eigen::VectorXd;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Nelder and Mead's own coefficients, as steps from the centre away from the worst corner.
constexpr double kReflect = 1, kExpand = 2, kContract = 0.5, kShrink = 0.5;
constexpr double kNoise = 0.1;  // share of the position tolerance below which values do not count
constexpr double kFlat = 0.1;   // of the first edges: a warm simplex as flat as this is stuck

}  // namespace

/// Once the evaluations are spent every point counts as infinitely bad, so that a move half made
/// takes none of them.
Corner SimplexSearch::evaluate(const VectorXd& at) {
  Corner corner{at.cwiseMax(lower_).cwiseMin(upper_), kInfinity};
  if (spent()) return corner;
  const double value = f_(corner.at);
  ++evaluations_;
  if (std::isfinite(value)) corner.value = value;
  if (evaluations_ == 1 || corner.value < best_.value) best_ = corner;
  if (observer_) observer_({evaluations_, corner.at, corner.value, best_.value, temperature_});
  return corner;
}

double SimplexSearch::temperature() const {
  const double share = evaluations_ / (options_.cooling_share * options_.max_evaluations);
  if (!(share < 1)) return 0;
  return options_.start_temperature * spread_ * std::pow(1 - share, options_.cooling_exponent);
}

void SimplexSearch::build(const VectorXd& at, double share) {
  temperature_ = 0;
  simplex_.assign(1, evaluate(at));
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    VectorXd corner = at;
    double step = share * edges_[i];
    if (at[i] + step > upper_[i] || at[i] + step < lower_[i]) step = -step;
    if (at[i] + step > upper_[i] || at[i] + step < lower_[i])
      step = upper_[i] - at[i] > at[i] - lower_[i] ? upper_[i] - at[i] : lower_[i] - at[i];
    corner[i] += step;
    simplex_.push_back(evaluate(corner));
  }
}

void SimplexSearch::start(const VectorXd& at) {
  build(at, 1);
  double low = kInfinity, high = -kInfinity;
  for (const Corner& corner : simplex_) {
    if (!std::isfinite(corner.value)) continue;
    low = std::min(low, corner.value);
    high = std::max(high, corner.value);
  }
  spread_ = std::clamp(high - low, 0.0, std::numeric_limits<double>::max());
}

/// Each corner as worse than it is by a random amount.
SimplexSearch::Order SimplexSearch::look() {
  Order order;
  for (const Corner& corner : simplex_) order.seen.push_back(corner.value + fluctuation());
  std::vector<std::size_t> rank(simplex_.size());
  std::iota(rank.begin(), rank.end(), std::size_t(0));
  std::stable_sort(rank.begin(), rank.end(),
                   [&](std::size_t a, std::size_t b) { return order.seen[a] < order.seen[b]; });
  order.best = rank.front();
  order.worst = rank.back();
  order.second_worst = rank[rank.size() - 2];
  return order;
}

void SimplexSearch::shrink(std::size_t towards) {
  const VectorXd centre = simplex_[towards].at;
  for (std::size_t i = 0; i < simplex_.size(); ++i)
    if (i != towards) simplex_[i] = evaluate(centre + kShrink * (simplex_[i].at - centre));
}

void SimplexSearch::move() {
  temperature_ = temperature();
  const Order order = look();
  Corner& worst = simplex_[order.worst];
  VectorXd centre = VectorXd::Zero(worst.at.size());
  for (std::size_t i = 0; i < simplex_.size(); ++i)
    if (i != order.worst) centre += simplex_[i].at / double(simplex_.size() - 1);
  const VectorXd away = centre - worst.at;
  const auto seen = [&](const Corner& trial) { return trial.value - fluctuation(); };

  const Corner reflected = evaluate(centre + kReflect * away);
  const double seen_reflected = seen(reflected);
  if (seen_reflected < order.seen[order.best]) {
    const Corner expanded = evaluate(centre + kExpand * away);
    worst = seen(expanded) < seen_reflected ? expanded : reflected;
  } else if (seen_reflected < order.seen[order.second_worst]) {
    worst = reflected;
  } else {
    const bool outside = seen_reflected < order.seen[order.worst];
    const Corner contracted = evaluate(centre + (outside ? kContract : -kContract) * away);
    if (seen(contracted) < std::min(seen_reflected, order.seen[order.worst]))
      worst = contracted;
    else
      shrink(order.best);
  }
}

bool SimplexSearch::flat() const {
  VectorXd low = simplex_.front().at, high = low;
  for (const Corner& corner : simplex_) {
    low = low.cwiseMin(corner.at);
    high = high.cwiseMax(corner.at);
  }
  return (high - low).cwiseQuotient(edges_).cwiseAbs().minCoeff() <= kFlat;
}

bool SimplexSearch::at_rest() const {
  double low = kInfinity, high = -kInfinity, apart = 0;
  for (const Corner& corner : simplex_) {
    low = std::min(low, corner.value);
    high = std::max(high, corner.value);
    const VectorXd offset = corner.at - simplex_.front().at;
    apart = std::max(apart, offset.cwiseQuotient(edges_).cwiseAbs().maxCoeff());
  }
  if (!std::isfinite(low)) return false;
  return apart <= kNoise * options_.position_tolerance ||
         (apart <= options_.position_tolerance && high - low <= value_tolerance());
}

}  // namespace regarment
