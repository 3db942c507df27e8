#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "render/image.h"

namespace regarment {

/// Light in linear units, 1 = white; premultiplied by opacity `a`.
struct Linear {
  float r = 0, g = 0, b = 0, a = 0;

  Linear operator+(const Linear& o) const { return {r + o.r, g + o.g, b + o.b, a + o.a}; }
  Linear operator*(float s) const { return {r * s, g * s, b * s, a * s}; }
};

/// `front` laid over `back`.
inline Linear over(const Linear& front, const Linear& back) {
  return front + back * (1.0F - front.a);
}

// The curves of sRGB as tables, made once.
inline const std::array<float, 256> kLinearFromSrgb = [] {
  std::array<float, 256> made{};
  for (std::size_t i = 0; i < made.size(); ++i) {
    const double v = double(i) / 255.0;
    made[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  }
  return made;
}();
inline const std::array<std::uint8_t, 4096> kSrgbFromLinear = [] {
  std::array<std::uint8_t, 4096> made{};
  for (std::size_t i = 0; i < made.size(); ++i) {
    const double v = double(i) / 4095.0;
    const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
    made[i] = static_cast<std::uint8_t>(std::lround(255.0 * s));
  }
  return made;
}();

/// One sRGB channel, 0..255, as linear light 0..1.
inline float linear_from_srgb(std::uint8_t value) { return kLinearFromSrgb[value]; }

/// Linear light, clamped to 0..1, as an sRGB channel.
inline std::uint8_t srgb_from_linear(float light) {
  const float clamped = light < 0.0F ? 0.0F : (light > 1.0F ? 1.0F : light);
  return kSrgbFromLinear[static_cast<std::size_t>(clamped * 4095.0F + 0.5F)];
}

inline Linear linear(Colour colour, float opacity = 1.0F) {
  return Linear{linear_from_srgb(colour[0]), linear_from_srgb(colour[1]),
                linear_from_srgb(colour[2]), 1.0F} *
         opacity;
}

inline Rgba srgb(const Linear& c) {
  if (c.a <= 0.0F) return {0, 0, 0, 0};
  const float inverse = 1.0F / c.a;
  return {srgb_from_linear(c.r * inverse), srgb_from_linear(c.g * inverse),
          srgb_from_linear(c.b * inverse),
          static_cast<std::uint8_t>(255.0F * std::min(c.a, 1.0F) + 0.5F)};
}

}  // namespace regarment
