#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "synthetic/sheet.h"

namespace regarment {

// The elastic energy of a sheet. Positions `x` are one per particle, m.

/// Adds tension and shear, N: minus the gradient of A/2 (k_s (|s| - 1)^2 + k_t (|t| - 1)^2 + k_st
/// (s.t)^2) over the elements, s and t being the images of their unit vectors. Stretched beyond
/// their length, elements shear more easily, so that far from rest nothing grows without bound.
void add_strain_forces(const Sheet& sheet, const std::vector<Vec3>& x, std::vector<Vec3>& forces);

/// Adds bending, N.
void add_bending_forces(const Sheet& sheet, const std::vector<Vec3>& x, std::vector<Vec3>& forces);

/// J. That of shear holds for elements no longer than at rest.
double strain_energy(const Sheet& sheet, const std::vector<Vec3>& x);
double bending_energy(const Sheet& sheet, const std::vector<Vec3>& x);

/// A constant matrix no softer than the energy in any direction, the same for x, y and z; N/m,
/// lower half.
Eigen::SparseMatrix<double> stiffness_bound(const Sheet& sheet);

}  // namespace regarment
