#pragma once

namespace regarment {

/// What a garment is made of: a woven or knitted sheet that stretches differently along the grain
/// (t, down the panel), across it (s) and in shear. SI units.
struct SheetFabric {
  double thickness = 0.002;          // m, 0.0005 .. 0.01
  double density = 0.25;             // kg / m^2
  double stiffness_along = 1500.0;   // N/m per unit strain along t: force over width
  double stiffness_across = 1500.0;  // N/m per unit strain along s
  double stiffness_shear = 300.0;    // N/m per unit shear strain
  double bending = 3e-5;             // N m, moment per width over curvature
  double friction = 0.3;             // of Coulomb's law, against the body and other cloth

  /// Throws InvalidInput naming the field and its value.
  void check() const;
};

}  // namespace regarment
