#pragma once

#include <array>
#include <vector>

#include "garment/pattern.h"

namespace regarment {

/// Two triangles that share a side: how far they are bent, as a linear function of four particles.
/// Exact for cloth bent without stretching [Bergou et al. 2006, "A quadratic bending model for
/// inextensible surfaces"]. sum_i weights[i] * x[particles[i]] is a vector, 1/m: 0 for flat cloth,
/// 3 / (2 R) long where the side runs along the axis of a cylinder of radius R.
struct Hinge {
  std::array<int, 4> particles{};   // opposite corners, then the ends of the side
  std::array<double, 4> weights{};  // 1/m^2, sum to 0
  double area = 0;                  // m^2 of cloth it stands for
};

/// Every inner side of the sewn pattern once, in the order of its triangles.
std::vector<Hinge> hinges(const Pattern& pattern);

}  // namespace regarment
