#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "garment/pattern.h"
#include "synthetic/fabric.h"

namespace regarment {

/// A triangle of cloth and its shape at rest.
struct SheetElement {
  std::array<std::uint32_t, 3> corner{};  // particles, counter-clockwise seen from outside
  // With P = [x1 - x0, x2 - x0], P across is the image of the unit vector along s, P along that of
  // the one along t; both have length 1 at rest and are perpendicular.
  Vec2 across = Vec2::Zero(), along = Vec2::Zero();  // 1/m
  double area = 0.0;                                 // m^2, at rest
  double layers = 1.0;                               // sheets of fabric lying on each other: 1 or 2
};

/// The quadratic bending energy 1/2 x^T Q x [Bergou et al. 2006, A Quadratic Bending Model for
/// Inextensible Surfaces], rows compressed. Q acts on x, y and z alike; N/m.
struct BendingMatrix {
  std::vector<std::uint32_t> begin;  // n + 1, first entry of each row
  std::vector<std::uint32_t> column;
  std::vector<double> value;
};

/// A sewn garment as a continuum: what does not change while it moves.
struct Sheet {
  SheetFabric fabric;
  std::vector<double> area;            // m^2 at rest, per particle
  std::vector<double> mass;            // kg, per particle, > 0
  std::vector<SheetElement> elements;  //
  std::vector<Triangle> triangles;     // corners of the elements, in their order
  BendingMatrix bending;
  std::vector<double> bending_diagonal;  // N/m, per particle
  // Particles at most two edges away, ascending, itself among them: never in contact with each
  // other.
  std::vector<std::vector<std::uint32_t>> near;
  std::vector<std::uint8_t> on_trunk;  // per particle: on a panel that goes round the trunk
  double edge_length = 0.0;            // m, mean

  std::size_t particle_count() const { return mass.size(); }
};

/// Makes a sheet of a pattern. Elements whose middle lies less than `band` below the panel's top
/// (t = 0) are of two layers. Throws InvalidInput for a fabric out of range and for triangles
/// without area.
Sheet make_sheet(const Pattern& pattern, const SheetFabric& fabric, double band = 0.0);

}  // namespace regarment
