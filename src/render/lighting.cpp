#include "render/lighting.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/hollows.h"

namespace regarment {
namespace {

struct Lamp {
  float x, y, z;  // unit vector towards the lamp: right, up, towards the viewer
  float r, g, b;
  float wrap;  // how far light reaches round the terminator, 0..1

  float facing(float nx, float ny, float nz) const {
    return std::max((x * nx + y * ny + z * nz + wrap) / (1.0F + wrap), 0.0F);
  }
};

constexpr Lamp kKey = {-0.48F, 0.60F, 0.64F, 0.66F, 0.64F, 0.60F, 0.15F};
constexpr Lamp kFill = {0.80F, 0.10F, 0.59F, 0.17F, 0.19F, 0.23F, 0.35F};

// Half-way between the key lamp and the viewer: where the surface shines.
constexpr std::array<float, 3> kHalf = {-0.265F, 0.331F, 0.906F};

Light studio(float nx, float ny, float nz) {
  const float key = kKey.facing(nx, ny, nz), fill = kFill.facing(nx, ny, nz);
  const float sky = 0.25F + 0.09F * ny;
  const float edge = 1.0F - nz;
  const float rim = 0.22F * edge * edge * edge * (0.6F + 0.4F * ny);
  float gloss = std::max(kHalf[0] * nx + kHalf[1] * ny + kHalf[2] * nz, 0.0F);
  for (int i = 0; i < 4; ++i) gloss *= gloss;  // 16th power: a wide, soft highlight
  return {key * kKey.r + fill * kFill.r + sky + rim, key * kKey.g + fill * kFill.g + sky + rim,
          key * kKey.b + fill * kFill.b + 1.06F * sky + rim, 0.035F * gloss};
}

// The normal's x and y in 128 steps each way, light interpolated between them.
class StudioTable {
 public:
  StudioTable() : table_(std::size_t(kSize) * kSize) {
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) {
        const float nx = float(i - kHalfSize) / kHalfSize, ny = float(j - kHalfSize) / kHalfSize;
        const float squared = nx * nx + ny * ny;
        const float length = std::max(std::sqrt(squared), 1.0F);
        const float nz = std::sqrt(std::max(1.0F - squared, 0.0F));
        table_[std::size_t(j) * kSize + i] = studio(nx / length, ny / length, nz);
      }
    }
  }

  Light at(const std::array<std::int16_t, 2>& normal) const {
    const float u = float(normal[0]) * (kHalfSize / 32768.0F) + kHalfSize;
    const float v = float(normal[1]) * (kHalfSize / 32768.0F) + kHalfSize;
    const int i = int(u), j = int(v);
    const float fu = u - float(i), fv = v - float(j);
    const Light* a = &table_[std::size_t(j) * kSize + i];
    const Light* b = a + kSize;
    const auto mix = [&](float Light::*c) {
      const float upper = a[0].*c + fu * (a[1].*c - a[0].*c);
      const float lower = b[0].*c + fu * (b[1].*c - b[0].*c);
      return upper + fv * (lower - upper);
    };
    return {mix(&Light::r), mix(&Light::g), mix(&Light::b), mix(&Light::shine)};
  }

 private:
  static constexpr int kHalfSize = 128, kSize = 2 * kHalfSize + 2;
  std::vector<Light> table_;
};

// Light that reaches a place `behind` metres behind its surroundings of width `radius`.
float open_sky(float behind, float radius, float strength) {
  const float t = std::clamp(behind / radius, 0.0F, 1.0F);
  return 1.0F - strength * t * (2.0F - t);
}

}  // namespace

std::vector<Light> light_surface(const GeometryBuffers& buffers, double pixels_per_metre) {
  static const StudioTable studio_table;
  constexpr float kNarrow = 0.02F, kWide = 0.07F;  // m
  std::vector<Light> light(buffers.id.size());
  if (light.empty()) return light;
  Hollows narrow(buffers, double(kNarrow) * pixels_per_metre);
  Hollows wide(buffers, double(kWide) * pixels_per_metre);
  for (int y = 0; y < buffers.height; ++y) {
    narrow.set_row(y);
    wide.set_row(y);
    for (std::size_t x = 0; x < std::size_t(buffers.width); ++x) {
      const std::size_t i = buffers.index(int(x), y);
      if (buffers.id[i] == 0) continue;
      const float depth = buffers.depth[i];
      const float open = open_sky(depth - narrow.depth_around(x), kNarrow, 0.32F) *
                         open_sky(depth - wide.depth_around(x), kWide, 0.30F);
      const Light lit = studio_table.at(buffers.normal[i]);
      light[i] = {open * lit.r, open * lit.g, open * lit.b, open * lit.shine};
    }
  }
  return light;
}

}  // namespace regarment
