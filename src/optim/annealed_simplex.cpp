#include "optim/annealed_simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "base/error.h"

namespace regarment {
namespace {

using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Nelder and Mead's own coefficients, as steps from the centre away from the worst corner.
constexpr double kReflect = 1, kExpand = 2, kContract = 0.5, kShrink = 0.5;
constexpr double kNoise = 0.1;    // share of the position tolerance below which values do not count
constexpr double kFlat = 0.1;     // of the first edges: a warm simplex as flat as this is stuck
constexpr double kRestart = 0.5;  // edges of a new simplex over those of the one before

struct Corner {
  VectorXd at;
  double value = kInfinity;
};

/// The corners of a simplex by how they are seen, worst and best first.
struct Order {
  std::vector<double> seen;
  std::size_t best = 0, worst = 0, second_worst = 0;
};

class Search {
 public:
  Search(const std::function<double(const VectorXd&)>& f, const VectorXd& edges,
         const VectorXd& lower, const VectorXd& upper, const AnnealedSimplexOptions& options,
         Random& random, const SearchObserver& observer)
      : f_(f),
        edges_(edges),
        lower_(lower),
        upper_(upper),
        options_(options),
        random_(random),
        observer_(observer) {}

  void start(const VectorXd& at);
  void restart(double share) { build(best_.at, share); }
  void move();

  bool warm() const { return temperature() > 0; }
  bool spent() const { return evaluations_ >= options_.max_evaluations; }
  bool flat() const;
  bool at_rest() const;
  const Corner& best() const { return best_; }
  double value_tolerance() const { return options_.value_tolerance * spread_; }
  int evaluations() const { return evaluations_; }

 private:
  void build(const VectorXd& at, double share);
  double temperature() const;
  Corner evaluate(const VectorXd& at);
  double fluctuation() { return temperature_ * -std::log(1 - random_.uniform()); }
  Order look();
  void shrink(std::size_t towards);

  const std::function<double(const VectorXd&)>& f_;
  const VectorXd &edges_, &lower_, &upper_;
  const AnnealedSimplexOptions& options_;
  Random& random_;
  const SearchObserver& observer_;
  std::vector<Corner> simplex_;  // dimension + 1
  Corner best_;                  // of all evaluations
  double spread_ = 0;            // largest less smallest finite value of the first simplex
  double temperature_ = 0;       // of the move being made
  int evaluations_ = 0;
};

/// Once the evaluations are spent every point counts as infinitely bad, so that a move half made
/// takes none of them.
Corner Search::evaluate(const VectorXd& at) {
  Corner corner{at.cwiseMax(lower_).cwiseMin(upper_), kInfinity};
  if (spent()) return corner;
  const double value = f_(corner.at);
  ++evaluations_;
  if (std::isfinite(value)) corner.value = value;
  if (evaluations_ == 1 || corner.value < best_.value) best_ = corner;
  if (observer_) observer_({evaluations_, corner.at, corner.value, best_.value, temperature_});
  return corner;
}

double Search::temperature() const {
  const double share = evaluations_ / (options_.cooling_share * options_.max_evaluations);
  if (!(share < 1)) return 0;
  return options_.start_temperature * spread_ * std::pow(1 - share, options_.cooling_exponent);
}

void Search::build(const VectorXd& at, double share) {
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

void Search::start(const VectorXd& at) {
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
Order Search::look() {
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

void Search::shrink(std::size_t towards) {
  const VectorXd centre = simplex_[towards].at;
  for (std::size_t i = 0; i < simplex_.size(); ++i)
    if (i != towards) simplex_[i] = evaluate(centre + kShrink * (simplex_[i].at - centre));
}

void Search::move() {
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

/// Pressed against a side of the box, or shrunk in a valley: it can no longer move every way.
bool Search::flat() const {
  VectorXd low = simplex_.front().at, high = low;
  for (const Corner& corner : simplex_) {
    low = low.cwiseMin(corner.at);
    high = high.cwiseMax(corner.at);
  }
  return (high - low).cwiseQuotient(edges_).cwiseAbs().minCoeff() <= kFlat;
}

bool Search::at_rest() const {
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

void require(bool right, const std::string& what) {
  if (!right) throw InvalidInput("minimize_annealed: " + what);
}

void check_input(const VectorXd& start, const VectorXd& edges, const VectorXd& lower,
                 const VectorXd& upper, const AnnealedSimplexOptions& options) {
  options.check();
  const Eigen::Index n = start.size();
  require(n > 0, "there is no dimension to search");
  require(edges.size() == n && lower.size() == n && upper.size() == n,
          "start has " + std::to_string(n) + " dimensions, edges " + std::to_string(edges.size()) +
              ", lower " + std::to_string(lower.size()) + ", upper " +
              std::to_string(upper.size()));
  require(options.max_evaluations >= n + 2,
          "max_evaluations is " + std::to_string(options.max_evaluations) + ", " +
              std::to_string(n) + " dimensions need at least " + std::to_string(n + 2));
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::string at = " in dimension " + std::to_string(i);
    require(lower[i] < upper[i], "the box has no width" + at);
    require(std::isfinite(start[i]) && start[i] >= lower[i] && start[i] <= upper[i],
            "the start " + std::to_string(start[i]) + " is not in the box" + at);
    require(std::isfinite(edges[i]) && edges[i] != 0,
            "the edge is " + std::to_string(edges[i]) + at);
  }
}

}  // namespace

void AnnealedSimplexOptions::check() const {
  const auto in = [](const char* field, double value, bool right) {
    if (!right)
      throw InvalidInput(std::string("AnnealedSimplexOptions: ") + field + " is " +
                         std::to_string(value));
  };
  in("max_evaluations", max_evaluations, max_evaluations >= 3);
  in("start_temperature", start_temperature,
     std::isfinite(start_temperature) && start_temperature >= 0);
  in("cooling_exponent", cooling_exponent, std::isfinite(cooling_exponent) && cooling_exponent > 0);
  in("cooling_share", cooling_share, cooling_share >= 0 && cooling_share <= 1);
  in("value_tolerance", value_tolerance, std::isfinite(value_tolerance) && value_tolerance >= 0);
  in("position_tolerance", position_tolerance,
     std::isfinite(position_tolerance) && position_tolerance >= 0);
}

SearchResult minimize_annealed(const std::function<double(const VectorXd&)>& f,
                               const VectorXd& start, const VectorXd& edges, const VectorXd& lower,
                               const VectorXd& upper, const AnnealedSimplexOptions& options,
                               Random& random, const SearchObserver& observer) {
  check_input(start, edges, lower, upper, options);
  Search search(f, edges, lower, upper, options, random, observer);
  search.start(start);
  double share = 1;
  if (search.warm()) {
    while (search.warm() && !search.spent()) {
      search.move();
      if (search.flat()) search.restart(1);
    }
    search.restart(share *= kRestart);
  }
  SearchEnding ending = SearchEnding::EvaluationLimit;
  double before = kInfinity;  // best value when the simplex last came to rest
  while (!search.spent()) {
    if (!search.at_rest()) {
      search.move();
    } else if (before - search.best().value <= search.value_tolerance()) {
      ending = SearchEnding::Converged;
      break;
    } else {
      before = search.best().value;
      search.restart(share *= kRestart);
    }
  }
  return {search.best().at, search.best().value, search.evaluations(), ending};
}

}  // namespace regarment
