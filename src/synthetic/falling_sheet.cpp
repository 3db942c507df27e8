#include "synthetic/falling_sheet.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "synthetic/sheet_forces.h"

namespace regarment {
namespace {

constexpr double kCollapsed = 1e-6;  // image of a unit vector shorter than this has no direction
constexpr double kMostBent = 0.5;    // of the steepest bending an explicit step can carry
constexpr std::size_t kSelfSearchEvery = 10;  // steps
constexpr std::size_t kFindEvery = 4;         // steps

/// The corners of an element while they are moved.
struct Corners {
  Vec3 x0, x1, x2;
  double w0, w1, w2;  // 1/kg

  Vec3 image(const Vec2& d) const { return d.x() * (x1 - x0) + d.y() * (x2 - x0); }
  /// Moves the corners along the gradients g1, g2 and -(g1 + g2) of a constraint whose value is
  /// `value`, by the compliance `soft` over the step's square.
  void hold(double value, const Vec3& g1, const Vec3& g2, double soft) {
    const Vec3 g0 = g1 + g2;
    const double by =
        -value / (w1 * g1.squaredNorm() + w2 * g2.squaredNorm() + w0 * g0.squaredNorm() + soft);
    x1 += by * w1 * g1;
    x2 += by * w2 * g2;
    x0 -= by * w0 * g0;
  }
  void hold_length(const Vec2& d, double soft) {
    const Vec3 along = image(d);
    const double length = along.norm();
    if (length < kCollapsed) return;
    hold(length - 1, d.x() / length * along, d.y() / length * along, soft);
  }
  void hold_angle(const SheetElement& e, double soft) {
    const Vec3 s = image(e.across), t = image(e.along);
    hold(s.dot(t), e.across.x() * t + e.along.x() * s, e.across.y() * t + e.along.y() * s, soft);
  }
};

}  // namespace

FallingSheet::FallingSheet(const Sheet& sheet, std::vector<Vec3> positions)
    : sheet_(sheet),
      x_(std::move(positions)),
      v_(x_.size(), Vec3::Zero()),
      before_(x_),
      self_(sheet) {
  if (x_.size() != sheet.particle_count())
    throw InvalidInput("FallingSheet: not one position per particle");
  for (std::size_t p = 0; p < sheet.mass.size(); ++p) {
    inverse_mass_.push_back(1 / sheet.mass[p]);
    steepest_ = std::max(steepest_, sheet.bending_diagonal[p] / sheet.mass[p]);
  }
}

void FallingSheet::predict(const FallOptions& options) {
  const double dt = options.time_step, kept = std::exp(-options.air * dt);
  const Vec3 fall(0, -options.gravity * dt, 0);
  // Cloth too stiff for an explicit step bends as stiffly as the step can carry.
  const double carried = std::min(1.0, kMostBent / std::max(dt * dt * steepest_, 1e-12));
  before_ = x_;
  bend_.assign(x_.size(), Vec3::Zero());
  add_bending_forces(sheet_, x_, bend_);
  for (std::size_t p = 0; p < x_.size(); ++p) {
    v_[p] += fall + (dt * inverse_mass_[p] * carried) * bend_[p];
    v_[p] *= kept;
    const double speed = v_[p].norm();
    if (speed > options.fastest) v_[p] *= options.fastest / speed;
    x_[p] += dt * v_[p];
  }
}

void FallingSheet::hold_shape(double dt, bool downwards) {
  const SheetFabric& fabric = sheet_.fabric;
  const std::size_t n = sheet_.elements.size();
  for (std::size_t k = 0; k < n; ++k) {
    const SheetElement& e = sheet_.elements[downwards ? k : n - 1 - k];
    const auto [a, b, c] = e.corner;
    Corners corners{x_[a], x_[b], x_[c], inverse_mass_[a], inverse_mass_[b], inverse_mass_[c]};
    const double soft = 1 / (e.area * e.layers * dt * dt);
    corners.hold_length(e.across, soft / fabric.stiffness_across);
    corners.hold_length(e.along, soft / fabric.stiffness_along);
    corners.hold_angle(e, soft / fabric.stiffness_shear);
    x_[a] = corners.x0, x_[b] = corners.x1, x_[c] = corners.x2;
  }
}

void FallingSheet::touch(const std::vector<const Obstacle*>& obstacles,
                         const FallOptions& options) {
  const bool all = contacts_.size() != obstacles.size();
  if (all) contacts_ = std::vector<SurfaceContact>(obstacles.size(), SurfaceContact(sheet_));
  if (options.self_contact) {
    if (steps_ % kSelfSearchEvery == 0) self_.find(x_);
    self_.separate(before_, x_);
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (all || steps_ % kFindEvery == 0) contacts_[i].find(*obstacles[i], x_, all);
    contacts_[i].push_out(*obstacles[i], before_, x_);
  }
}

void FallingSheet::step(const std::vector<const Obstacle*>& obstacles, const FallOptions& options) {
  predict(options);
  // Both ways, or cloth would creep in the direction of the sweep.
  hold_shape(options.time_step, true);
  hold_shape(options.time_step, false);
  touch(obstacles, options);
  for (const std::uint32_t p : held_) x_[p].y() = before_[p].y();
  for (std::size_t p = 0; p < x_.size(); ++p) v_[p] = (x_[p] - before_[p]) / options.time_step;
  ++steps_;
}

double FallingSheet::speed(double share) const { return length_quantile(v_, share); }

double length_quantile(const std::vector<Vec3>& vectors, double share) {
  if (vectors.empty()) return 0;
  std::vector<double> lengths;
  lengths.reserve(vectors.size());
  for (const Vec3& v : vectors) lengths.push_back(v.norm());
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(lengths.size() - 1));
  std::nth_element(lengths.begin(), lengths.begin() + at, lengths.end());
  return lengths[static_cast<std::size_t>(at)];
}

}  // namespace regarment
