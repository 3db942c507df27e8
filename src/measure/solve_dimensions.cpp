#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "measure/observe.h"

namespace regarment {
namespace {

constexpr double kDifference = 1e-6;  // m, for the slopes of the formulas
constexpr double kWeakPrior = 0.5;    // m, keeps dimensions that nothing depends on where they are
constexpr double kTightCurvature = 1e-9;  // of a direction the observations say something about

}  // namespace

std::map<std::string, SolvedDimension> solve_dimensions(const GarmentTemplate& garment,
                                                        const std::vector<ObservedLength>& observed,
                                                        const Dimensions& fixed) {
  const std::vector<Dimension>& names = garment.dimensions();
  const auto n = static_cast<Eigen::Index>(names.size());
  Dimensions at = garment.typical();
  for (const auto& [name, value] : fixed) at[name] = value;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd touched = Eigen::VectorXd::Zero(n);
  for (int round = 0; round < 12; ++round) {
    information = Eigen::MatrixXd::Identity(n, n) / (kWeakPrior * kWeakPrior);
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(n);
    touched.setZero();
    for (const ObservedLength& o : observed) {
      if (!o.seen) continue;
      const double value = garment.evaluate(o.observation->equals, at);
      Eigen::VectorXd slope(n);
      for (Eigen::Index k = 0; k < n; ++k) {
        const std::string& name = names[static_cast<std::size_t>(k)].name;
        if (fixed.contains(name)) {
          slope[k] = 0;
          continue;
        }
        Dimensions moved = at;
        moved[name] += kDifference;
        slope[k] = (garment.evaluate(o.observation->equals, moved) - value) / kDifference;
      }
      const double weight = 1 / (o.standard_deviation * o.standard_deviation);
      information += weight * slope * slope.transpose();
      pull += weight * (o.value - value) * slope;
      touched += slope.cwiseAbs2();
    }
    const Eigen::VectorXd step = information.ldlt().solve(pull);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Dimension& d = names[static_cast<std::size_t>(k)];
      at[d.name] = std::clamp(at[d.name] + step[k], d.lower, d.upper);
    }
    if (step.cwiseAbs().maxCoeff() < 1e-9) break;
  }
  const Eigen::MatrixXd covariance = information.inverse();
  std::map<std::string, SolvedDimension> out;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Dimension& d = names[static_cast<std::size_t>(k)];
    SolvedDimension s;
    s.observable = touched[k] > kTightCurvature;
    s.value = s.observable ? at[d.name] : d.typical;
    s.standard_deviation = s.observable ? std::sqrt(covariance(k, k)) : (d.upper - d.lower) / 4;
    if (fixed.contains(d.name)) s = {fixed.at(d.name), 0.0, true};
    out[d.name] = s;
  }
  return out;
}

}  // namespace regarment
