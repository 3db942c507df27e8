#pragma once

#include <Eigen/SparseCholesky>
#include <memory>
#include <vector>

#include "synthetic/self_contact.h"
#include "synthetic/sheet_forces.h"
#include "synthetic/surface_contact.h"

namespace regarment {

/// How a sheet comes to rest.
struct RestOptions {
  double time_step = 0.01;  // s
  double gravity = 9.81;    // m/s^2, down (-y)
  double air = 2.0;         // 1/s, share of its speed cloth loses to the air
  double fastest = 2.0;     // m/s, nothing moves faster
  int iterations = 2;       // of each step; more bends and swings more freely on the way
  double pressure = 1e7;    // N/m^3, of what is touched: a pressure over how deep it presses in
  bool self_contact = true;
};

/// Brings a sheet that hangs nearly at rest to rest exactly: implicit Euler steps, each lowered
/// towards its energy by a quasi-Newton method with a constant bound of the stiffness [Liu et al.
/// 2017, Quasi-Newton Methods for Real-Time Simulation of Hyperelastic Materials], which is
/// factored anew only as contacts come and go. Whatever the number of iterations, it rests only
/// where the true forces balance. It evens out tension in a few steps; it turns and folds slowly,
/// which is what FallingSheet is for.
class RestingSheet {
 public:
  /// `sheet` must outlive this object; one position per particle, m; at rest to begin with.
  /// Throws InvalidInput when the sizes differ.
  RestingSheet(const Sheet& sheet, std::vector<Vec3> positions);

  /// This particle stays where it is.
  void pin(std::size_t particle) { pinned_[particle] = 1; }

  /// One time step against these obstacles (the same ones, in the same order, every time).
  void step(const std::vector<const Obstacle*>& obstacles, const RestOptions& options);

  const Sheet& sheet() const { return sheet_; }
  const std::vector<Vec3>& positions() const { return x_; }
  /// The speed that `share` of the particles do not pass, m/s.
  double speed(double share) const;
  /// Drops all speed.
  void stop() { v_.assign(v_.size(), Vec3::Zero()); }

 private:
  void find_contacts(const std::vector<const Obstacle*>& obstacles, const RestOptions& options);
  void factor(const std::vector<const Obstacle*>& obstacles, const RestOptions& options);
  std::vector<Vec3> forces(const std::vector<const Obstacle*>& obstacles,
                           const RestOptions& options) const;

  const Sheet& sheet_;
  std::vector<Vec3> x_, v_;
  std::vector<Vec3> before_, aim_;  // at the step's beginning; where inertia and gravity lead
  std::vector<std::uint8_t> pinned_;
  SelfContact self_;
  std::vector<SurfaceContact> contacts_;  // one per obstacle
  std::size_t steps_ = 0;

  Eigen::SparseMatrix<double> bound_;  // of the elastic energy alone, lower half
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace regarment
