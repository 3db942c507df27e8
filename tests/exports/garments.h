#pragma once

#include <cmath>

#include "garment/find_template.h"
#include "garment/pattern.h"

// Garments of whole numbers of centimetres, and lengths of their pieces by hand.

namespace regarment {

inline Dimensions whole_skirt() {
  return {{"length", 0.60}, {"width", 1.20}, {"waist", 0.72}, {"hip", 0.96}};
}

/// Waist to hip line and hip line to hem, on the half of a front: the hip line lies 20 cm down.
inline double skirt_upper_side() { return std::hypot(0.96 / 4 - 0.72 / 4, 0.20); }
inline double skirt_lower_side() { return std::hypot(1.20 / 4 - 0.96 / 4, 0.40); }

/// Two trapezia.
inline double skirt_area() { return (0.36 + 0.48) / 2 * 0.20 + (0.48 + 0.60) / 2 * 0.40; }

inline Dimensions whole_tshirt() {
  return {{"length", 0.70},
          {"width", 1.00},
          {"sleeve_length", 0.20},
          {"sleeve_opening", 0.34},
          {"sleeve_seam", 0.46}};
}

/// Half an ellipse of half axes 9 and 7 cm, by adding up a hundred thousand chords.
inline double neck_length() {
  double length = 0.0;
  constexpr int kParts = 100'000;
  for (int k = 0; k < kParts; ++k) {
    const double a = M_PI * k / kParts, b = M_PI * (k + 1) / kParts;
    length += std::hypot(0.09 * (std::cos(b) - std::cos(a)), 0.07 * (std::sin(b) - std::sin(a)));
  }
  return length;
}

/// Neck (9 cm from the centre) to the shoulder point, which lies at 0.86 of a quarter of the width
/// on a line that falls 20 degrees.
inline double shoulder_length() { return (0.86 * 0.25 - 0.09) / std::cos(20.0 * M_PI / 180.0); }

/// A skirt's front and back laid flat, 20 cm apart, its vertices on seams in between.
inline std::vector<Vec3> laid_flat(const Pattern& pattern) {
  std::vector<int> sharing(static_cast<std::size_t>(pattern.particle_count), 0);
  for (const int particle : pattern.particle) ++sharing[static_cast<std::size_t>(particle)];
  std::vector<Vec3> out;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const bool sewn = sharing[static_cast<std::size_t>(pattern.particle[v])] > 1;
    const bool front = pattern.panel_is_front[static_cast<std::size_t>(pattern.panel[v])];
    const double z = sewn ? 0.0 : front ? 0.1 : -0.1;
    out.emplace_back(pattern.flat[v].x(), 1.0 - pattern.flat[v].y(), z);
  }
  return out;
}

}  // namespace regarment
