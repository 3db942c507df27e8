#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "optim/annealed_simplex.h"

namespace regarment::test {

using Eigen::VectorXd;

inline VectorXd vec(std::initializer_list<double> values) {
  VectorXd out(Eigen::Index(values.size()));
  std::copy(values.begin(), values.end(), out.data());
  return out;
}

/// Smallest value 0 at (1, ..., 1), at the end of a curved valley.
inline double rosenbrock(const VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i)
    sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
  return sum;
}

/// Smallest value 0 at 0, where the Hessian is singular.
inline double powell(const VectorXd& x) {
  return std::pow(x[0] + 10 * x[1], 2) + 5 * std::pow(x[2] - x[3], 2) +
         std::pow(x[1] - 2 * x[2], 4) + 10 * std::pow(x[0] - x[3], 4);
}

/// Four smallest values 0, at `himmelblau_minima`.
inline double himmelblau(const VectorXd& x) {
  return std::pow(x[0] * x[0] + x[1] - 11, 2) + std::pow(x[0] + x[1] * x[1] - 7, 2);
}

inline std::vector<VectorXd> himmelblau_minima() {
  return {vec({3, 2}), vec({-2.805118, 3.131312}), vec({-3.779310, -3.283186}),
          vec({3.584428, -1.848126})};
}

/// A search that remembers its steps. The box is wide unless told otherwise.
struct Searched {
  SearchResult result;
  std::vector<SearchStep> steps;
};

struct Search {
  VectorXd start, edges;
  AnnealedSimplexOptions options;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  Searched of(const std::function<double(const VectorXd&)>& f, std::uint64_t seed = 1) const {
    Random random(seed);
    Searched out;
    const VectorXd side = VectorXd::Ones(start.size());
    out.result = minimize_annealed(f, start, edges, low * side, high * side, options, random,
                                   [&](const SearchStep& step) { out.steps.push_back(step); });
    return out;
  }
};

inline bool same_steps(const Searched& a, const Searched& b) {
  if (a.steps.size() != b.steps.size()) return false;
  for (std::size_t i = 0; i < a.steps.size(); ++i)
    if (a.steps[i].at != b.steps[i].at) return false;
  return true;
}

}  // namespace regarment::test
