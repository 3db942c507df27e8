#include "render/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.h"

namespace regarment {
namespace {

// Control points in CIE L*a*b* (D65), evenly spaced. Lightness is exactly linear (Viridis), or
// linear on each side of the middle and the same at both ends (Diverging).
struct Lab {
  double l, a, b;
};

constexpr std::array<Lab, 9> kDiverging = {{{24, 4, -34},
                                            {42, -8, -38},
                                            {60, -14, -30},
                                            {78, -10, -16},
                                            {96, 0, 0},
                                            {78, 14, 18},
                                            {60, 30, 30},
                                            {42, 42, 34},
                                            {24, 38, 26}}};

constexpr std::array<Lab, 9> kViridis = {{{15, 39, -32},
                                          {24.5, 32, -37},
                                          {34, 18, -34},
                                          {43.5, 0, -26},
                                          {53, -18, -14},
                                          {62.5, -33, 5},
                                          {72, -41, 33},
                                          {81.5, -33, 62},
                                          {91, -12, 84}}};

double delinear(double t) {
  constexpr double kDelta = 6.0 / 29.0;
  return t > kDelta ? t * t * t : 3.0 * kDelta * kDelta * (t - 4.0 / 29.0);
}

std::uint8_t srgb_channel(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * s));
}

Colour colour_from(const Lab& lab) {
  const double fy = (lab.l + 16.0) / 116.0;
  const double x = 0.95047 * delinear(fy + lab.a / 500.0);
  const double y = delinear(fy);
  const double z = 1.08883 * delinear(fy - lab.b / 200.0);
  return {srgb_channel(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          srgb_channel(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          srgb_channel(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

Lab between(const std::array<Lab, 9>& points, double t) {
  const double place = t * double(points.size() - 1);
  const auto i = std::min(std::size_t(place), points.size() - 2);
  const double f = place - double(i);
  const Lab &p = points[i], &q = points[i + 1];
  return {p.l + f * (q.l - p.l), p.a + f * (q.a - p.a), p.b + f * (q.b - p.b)};
}

}  // namespace

Colour no_data_colour() { return {160, 160, 160}; }

Colour palette_colour(Palette palette, double t) {
  if (std::isnan(t)) return no_data_colour();
  const double place = std::clamp(t, 0.0, 1.0);
  return colour_from(between(palette == Palette::Diverging ? kDiverging : kViridis, place));
}

Colour ColourScale::colour(double value) const {
  return palette_colour(palette, (value - low) / (high - low));
}

ColourScale symmetric_scale(double range) {
  if (!(range > 0.0) || !std::isfinite(range)) {
    throw InvalidInput("the range of a colour scale is " + std::to_string(range) + ", must be > 0");
  }
  return {Palette::Diverging, -range, range};
}

double symmetric_range(const std::vector<float>& values, double fallback) {
  std::vector<double> sizes;
  for (const float value : values) {
    if (std::isfinite(value)) sizes.push_back(std::abs(double(value)));
  }
  if (sizes.empty()) return fallback;
  const auto middle = sizes.begin() + std::ptrdiff_t(0.95 * double(sizes.size() - 1));
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (!(*middle > 0.0)) return fallback;
  const double ten = std::pow(10.0, std::floor(std::log10(*middle)));
  for (const double step : {1.0, 2.0, 5.0}) {
    // A hair of room, so that 0.02f asks for 0.02 and not for 0.05.
    if (*middle <= step * ten * (1.0 + 1e-6)) return step * ten;
  }
  return 10.0 * ten;
}

Image colour_bar(const ColourScale& scale, int width, int height) {
  Image bar(width, height);
  for (int x = 0; x < width; ++x) {
    const Colour c = palette_colour(scale.palette, (x + 0.5) / width);
    for (int y = 0; y < height; ++y) bar.at(x, y) = {c[0], c[1], c[2], 255};
  }
  return bar;
}

Colour garment_colour(int layer) {
  // After Okabe and Ito, in an order that keeps neighbours apart in lightness as well as in hue.
  constexpr std::array<Colour, 6> kGarments = {{{38, 110, 180},
                                                {232, 150, 40},
                                                {0, 150, 118},
                                                {206, 124, 168},
                                                {238, 214, 70},
                                                {96, 184, 232}}};
  constexpr Colour kPerson = {212, 209, 204};
  if (layer <= 0) return kPerson;
  return kGarments[std::size_t(layer - 1) % kGarments.size()];
}

Colour unsure_colour() { return {168, 30, 60}; }

Colour label_colour(int label, float probability) {
  // Half sure is as unsure as a label can be; above 95 % nothing need be said.
  constexpr float kSure = 0.95F, kHalf = 0.5F, kMost = 0.85F;
  const float share = kMost * std::clamp((kSure - probability) / (kSure - kHalf), 0.0F, 1.0F);
  const Colour own = garment_colour(label), unsure = unsure_colour();
  Colour out;
  for (std::size_t c = 0; c < 3; ++c) {
    const float mixed = (1.0F - share) * float(own[c]) + share * float(unsure[c]);
    out[c] = static_cast<std::uint8_t>(std::lround(mixed));
  }
  return out;
}

Colour border_colour() { return {38, 40, 46}; }

std::string css_colour(Colour colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", unsigned(colour[0]), unsigned(colour[1]),
                unsigned(colour[2]));
  return {text.data(), 7};
}

}  // namespace regarment
