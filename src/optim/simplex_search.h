#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "optim/annealed_simplex.h"

namespace regarment {

/// A point that was measured; infinity stands for a value that is not finite.
struct Corner {
  Eigen::VectorXd at;
  double value = std::numeric_limits<double>::infinity();
};

/// A simplex on its way: what it knows, and one move at a time. Borrows all it is given.
class SimplexSearch {
 public:
  SimplexSearch(const std::function<double(const Eigen::VectorXd&)>& f,
                const Eigen::VectorXd& edges, const Eigen::VectorXd& lower,
                const Eigen::VectorXd& upper, const AnnealedSimplexOptions& options, Random& random,
                const SearchObserver& observer)
      : f_(f),
        edges_(edges),
        lower_(lower),
        upper_(upper),
        options_(options),
        random_(random),
        observer_(observer) {}

  /// The first simplex: `at` and one corner along each edge. Its spread of values is the scale of
  /// temperature and tolerance.
  void start(const Eigen::VectorXd& at);
  /// A new simplex round the best point so far, `share` as large as the first. Measures that again.
  void restart(double share) { build(Eigen::VectorXd(best_.at), share); }
  /// One step of Nelder and Mead, of corners and trial points seen through the temperature.
  void move();

  bool warm() const { return temperature() > 0; }
  bool spent() const { return evaluations_ >= options_.max_evaluations; }
  /// Pressed against a side of the box, or shrunk in a valley: it can no longer move every way.
  bool flat() const;
  /// Corners and values as near to each other as the options ask.
  bool at_rest() const;
  const Corner& best() const { return best_; }
  double value_tolerance() const { return options_.value_tolerance * spread_; }
  int evaluations() const { return evaluations_; }

 private:
  /// The corners of a simplex by how they are seen, worst and best first.
  struct Order {
    std::vector<double> seen;
    std::size_t best = 0, worst = 0, second_worst = 0;
  };

  void build(const Eigen::VectorXd& at, double share);
  double temperature() const;
  Corner evaluate(const Eigen::VectorXd& at);
  double fluctuation() { return temperature_ * -std::log(1 - random_.uniform()); }
  Order look();
  void shrink(std::size_t towards);

  const std::function<double(const Eigen::VectorXd&)>& f_;
  const Eigen::VectorXd &edges_, &lower_, &upper_;
  const AnnealedSimplexOptions& options_;
  Random& random_;
  const SearchObserver& observer_;
  std::vector<Corner> simplex_;  // dimension + 1
  Corner best_;                  // of all evaluations
  double spread_ = 0;            // largest less smallest finite value of the first simplex
  double temperature_ = 0;       // of the move being made
  int evaluations_ = 0;
};

}  // namespace regarment
