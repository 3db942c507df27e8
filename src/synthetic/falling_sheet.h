#pragma once

#include <vector>

#include "synthetic/self_contact.h"
#include "synthetic/sheet.h"
#include "synthetic/surface_contact.h"

namespace regarment {

/// How a sheet falls.
struct FallOptions {
  double time_step = 0.001;  // s. Smaller stretches less while it falls
  double gravity = 9.81;     // m/s^2, down (-y)
  double air = 2.0;          // 1/s, share of its speed cloth loses to the air
  double fastest = 2.0;      // m/s, nothing moves faster
  bool self_contact = true;
};

/// A sheet that swings, folds and slides into place: position based dynamics with compliance, one
/// sweep each way over the elements in many small steps [Macklin et al. 2019, Small Steps in
/// Physics Simulation; strain as in Müller et al. 2014]. Obstacles and folds push particles out at
/// once. Stiff cloth hangs somewhat longer than it should while it falls; RestingSheet ends that.
class FallingSheet {
 public:
  /// `sheet` must outlive this object; one position per particle, m; at rest to begin with.
  /// Throws InvalidInput when the sizes differ.
  FallingSheet(const Sheet& sheet, std::vector<Vec3> positions);

  /// Keeps these particles at their height, as a wearer's hands do.
  void hold_level(std::vector<std::uint32_t> particles) { held_ = std::move(particles); }

  /// One time step against these obstacles (the same ones, in the same order, every time).
  void step(const std::vector<const Obstacle*>& obstacles, const FallOptions& options);

  const std::vector<Vec3>& positions() const { return x_; }
  /// The speed that `share` of the particles do not pass, m/s.
  double speed(double share) const;

 private:
  void predict(const FallOptions& options);
  void hold_shape(double dt, bool downwards);
  void touch(const std::vector<const Obstacle*>& obstacles, const FallOptions& options);

  const Sheet& sheet_;
  std::vector<double> inverse_mass_;
  double steepest_ = 0.0;  // 1/s^2, greatest bending stiffness of a particle over its mass
  std::vector<Vec3> x_, v_, before_, bend_;
  std::vector<std::uint32_t> held_;
  SelfContact self_;
  std::vector<SurfaceContact> contacts_;  // one per obstacle
  std::size_t steps_ = 0;
};

/// The value that `share` of the lengths of `vectors` do not pass; 0 for none.
double length_quantile(const std::vector<Vec3>& vectors, double share);

}  // namespace regarment
