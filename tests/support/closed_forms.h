#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "geometry/mesh.h"

namespace regarment::test {

inline double circle_length(double radius) { return 2 * std::numbers::pi * radius; }

/// Perimeter of an ellipse by the series in the squared third eccentricity (Ivory, Bessel); the
/// terms left out are below 1e-9 of it for axes up to 3 : 1.
inline double ellipse_length(double a, double b) {
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  double sum = 1, factor = 1;
  for (int n = 1; n <= 12; ++n) {
    factor *= (0.5 - (n - 1)) / n;  // binomial coefficient of 1/2 over n
    sum += factor * factor * std::pow(h, n);
  }
  return std::numbers::pi * (a + b) * sum;
}

/// Length of a plane curve over t in 0..1 by a very fine polyline.
inline double curve_length(const std::function<Vec2(double)>& curve, int pieces = 200'000) {
  double length = 0;
  for (int k = 0; k < pieces; ++k)
    length += (curve((k + 1.0) / pieces) - curve(static_cast<double>(k) / pieces)).norm();
  return length;
}

}  // namespace regarment::test
