#pragma once

#include <functional>
#include <vector>

namespace regarment {

using LogLikelihood = std::function<double(const std::vector<double>&)>;

/// Draws from a distribution of independent standard normal variables times a likelihood, by
/// sequential Monte Carlo: the likelihood is let in step by step, and after each step the draws are
/// chosen anew by their weights and moved at random (Del Moral, Doucet and Jasra 2006). Finds
/// several peaks where there are several. `dimensions` >= 1 variables per draw; the same draws
/// every time. The likelihood must be finite for finite variables.
std::vector<std::vector<double>> posterior_sample(std::size_t dimensions,
                                                  const LogLikelihood& log_likelihood);

}  // namespace regarment
