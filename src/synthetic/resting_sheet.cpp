#include "synthetic/resting_sheet.h"

#include <cmath>

#include "base/error.h"
#include "synthetic/falling_sheet.h"

namespace regarment {
namespace {

constexpr std::size_t kSelfSearchEvery = 2;  // steps
constexpr std::size_t kFactorEvery = 4;      // steps
constexpr double kPinned = 1e9;              // N/m

}  // namespace

RestingSheet::RestingSheet(const Sheet& sheet, std::vector<Vec3> positions)
    : sheet_(sheet),
      x_(std::move(positions)),
      v_(x_.size(), Vec3::Zero()),
      before_(x_),
      aim_(x_),
      pinned_(x_.size(), 0),
      self_(sheet),
      bound_(stiffness_bound(sheet)) {
  if (x_.size() != sheet.particle_count())
    throw InvalidInput("RestingSheet: not one position per particle");
  solver_.analyzePattern(bound_);
}

void RestingSheet::find_contacts(const std::vector<const Obstacle*>& obstacles,
                                 const RestOptions& options) {
  const bool all = contacts_.size() != obstacles.size();
  if (all) contacts_ = std::vector<SurfaceContact>(obstacles.size(), SurfaceContact(sheet_));
  if (options.self_contact && steps_ % kSelfSearchEvery == 0) self_.find(x_);
  for (std::size_t i = 0; i < obstacles.size(); ++i) contacts_[i].find(*obstacles[i], x_, all);
}

void RestingSheet::factor(const std::vector<const Obstacle*>& obstacles,
                          const RestOptions& options) {
  std::vector<double> more(x_.size(), 0.0);
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    contacts_[i].add_stiffness(*obstacles[i], x_, options.pressure, more);
  if (options.self_contact) self_.add_stiffness(options.pressure, more);
  Eigen::SparseMatrix<double> matrix = bound_;
  const double per_mass = 1 / (options.time_step * options.time_step);
  for (std::size_t p = 0; p < x_.size(); ++p) {
    const auto i = static_cast<Eigen::Index>(p);
    matrix.coeffRef(i, i) += sheet_.mass[p] * per_mass + more[p] + (pinned_[p] ? kPinned : 0.0);
  }
  solver_.factorize(matrix);
  if (solver_.info() != Eigen::Success)
    throw InvalidInput("the cloth's stiffness has no factorisation: the fabric is out of range");
}

std::vector<Vec3> RestingSheet::forces(const std::vector<const Obstacle*>& obstacles,
                                       const RestOptions& options) const {
  const double per_mass = 1 / (options.time_step * options.time_step);
  std::vector<Vec3> out(x_.size());
  for (std::size_t p = 0; p < x_.size(); ++p)
    out[p] = sheet_.mass[p] * per_mass * (aim_[p] - x_[p]);
  add_strain_forces(sheet_, x_, out);
  add_bending_forces(sheet_, x_, out);
  if (options.self_contact) self_.add_forces(before_, x_, options.pressure, out);
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    contacts_[i].add_forces(*obstacles[i], x_, options.pressure, out);
  for (std::size_t p = 0; p < x_.size(); ++p)
    if (pinned_[p]) out[p].setZero();
  return out;
}

void RestingSheet::step(const std::vector<const Obstacle*>& obstacles, const RestOptions& options) {
  const double dt = options.time_step, kept = std::exp(-options.air * dt);
  find_contacts(obstacles, options);
  if (steps_ % kFactorEvery == 0) factor(obstacles, options);
  before_ = x_;
  for (std::size_t p = 0; p < x_.size(); ++p) {
    if (!pinned_[p]) x_[p] += (dt * kept) * v_[p];
    aim_[p] = x_[p] - Vec3(0, options.gravity * dt * dt, 0);
  }
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  for (int i = 0; i < options.iterations; ++i) {
    const std::vector<Vec3> push = forces(obstacles, options);
    Columns right(static_cast<Eigen::Index>(push.size()), 3);
    for (std::size_t p = 0; p < push.size(); ++p)
      right.row(static_cast<Eigen::Index>(p)) = push[p].transpose();
    const Columns move = solver_.solve(right);
    for (std::size_t p = 0; p < x_.size(); ++p)
      x_[p] += move.row(static_cast<Eigen::Index>(p)).transpose();
  }
  for (std::size_t p = 0; p < x_.size(); ++p) {
    v_[p] = (x_[p] - before_[p]) / dt;
    const double speed = v_[p].norm();
    if (speed <= options.fastest) continue;
    v_[p] *= options.fastest / speed;
    x_[p] = before_[p] + dt * v_[p];
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) contacts_[i].settle(*obstacles[i], x_);
  ++steps_;
}

double RestingSheet::speed(double share) const { return length_quantile(v_, share); }

}  // namespace regarment
