#include "fabric/posterior_sample.h"

#include <array>
#include <cmath>

#include "base/random.h"

namespace regarment {
namespace {

constexpr std::size_t kDraws = 600;
// Powers of the likelihood, step by step.
constexpr std::array<double, 9> kPowers = {0.01, 0.03, 0.07, 0.13, 0.22, 0.36, 0.55, 0.77, 1.0};
constexpr int kMoves = 5;            // of each draw after each step
constexpr double kMoveLength = 0.8;  // of a move against the spread of the draws

struct Draw {
  std::vector<double> at;
  double log_likelihood = 0;
};

// As many draws again, each as often as its weight, evenly picked (systematic resampling).
std::vector<Draw> resampled(const std::vector<Draw>& draws, double power, Random& random) {
  double best = -1e300, total = 0;
  for (const Draw& draw : draws) best = std::max(best, draw.log_likelihood);
  std::vector<double> weights;
  for (const Draw& draw : draws) {
    weights.push_back(std::exp(power * (draw.log_likelihood - best)));
    total += weights.back();
  }
  std::vector<Draw> out;
  const auto n = static_cast<double>(draws.size());
  double reached = 0, next = random.uniform() / n;
  for (std::size_t k = 0; k < draws.size(); ++k) {
    reached += weights[k] / total;
    for (; next < reached && out.size() < draws.size(); next += 1 / n) out.push_back(draws[k]);
  }
  while (out.size() < draws.size()) out.push_back(draws.back());  // rounding left one over
  return out;
}

std::vector<double> spread_of(const std::vector<Draw>& draws, std::size_t dimensions) {
  std::vector<double> out;
  const auto n = static_cast<double>(draws.size());
  for (std::size_t d = 0; d < dimensions; ++d) {
    double first = 0, second = 0;
    for (const Draw& draw : draws) {
      first += draw.at[d] / n;
      second += draw.at[d] * draw.at[d] / n;
    }
    out.push_back(std::sqrt(std::max(second - first * first, 1e-8)));
  }
  return out;
}

double squared(const std::vector<double>& x) {
  double out = 0;
  for (const double value : x) out += value * value;
  return out;
}

// A step of Metropolis: kept when it leads to a likely place.
void move_once(const LogLikelihood& log_likelihood, double power, const std::vector<double>& spread,
               Random& random, Draw& draw) {
  Draw other = draw;
  for (std::size_t d = 0; d < spread.size(); ++d) {
    other.at[d] += kMoveLength * spread[d] * random.normal();
  }
  other.log_likelihood = log_likelihood(other.at);
  const double gain = power * (other.log_likelihood - draw.log_likelihood) +
                      0.5 * (squared(draw.at) - squared(other.at));
  if (std::log(1 - random.uniform()) < gain) draw = std::move(other);
}

}  // namespace

std::vector<std::vector<double>> posterior_sample(std::size_t dimensions,
                                                  const LogLikelihood& log_likelihood) {
  Random random(1);
  std::vector<Draw> draws(kDraws);
  for (Draw& draw : draws) {
    for (std::size_t d = 0; d < dimensions; ++d) draw.at.push_back(random.normal());
    draw.log_likelihood = log_likelihood(draw.at);
  }
  double power = 0;
  for (const double next : kPowers) {
    draws = resampled(draws, next - power, random);
    power = next;
    const std::vector<double> spread = spread_of(draws, dimensions);
    for (Draw& draw : draws) {
      for (int k = 0; k < kMoves; ++k) move_once(log_likelihood, power, spread, random, draw);
    }
  }
  std::vector<std::vector<double>> out;
  out.reserve(draws.size());
  for (Draw& draw : draws) out.push_back(std::move(draw.at));
  return out;
}

}  // namespace regarment
