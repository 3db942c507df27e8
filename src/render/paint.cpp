#include "render/paint.h"

#include <algorithm>
#include <cmath>

namespace regarment {
namespace {

constexpr float kWireShade = 0.30F;  // lines are this much of the surface's colour

Linear lit(Colour albedo, const Light& light, float evenness) {
  const float studio = 1.0F - evenness, shine = studio * light.shine;
  return {linear_from_srgb(albedo[0]) * (studio * light.r + evenness) + shine,
          linear_from_srgb(albedo[1]) * (studio * light.g + evenness) + shine,
          linear_from_srgb(albedo[2]) * (studio * light.b + evenness) + shine, 1.0F};
}

float height_over(const Eigen::Vector2f& p, const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  const Eigen::Vector2f along = b - a, to = p - a;
  const float length = along.norm();
  return length > 1e-6F ? std::abs(along.x() * to.y() - along.y() * to.x()) / length : 0.0F;
}

// 1 on a line, 0 away from it. Triangles that are small in the picture get faint lines, or a fine
// mesh would be all line.
float wire_strength(const Surface& surface, const Triangle& t, int x, int y, float width) {
  const Eigen::Vector2f p(float(x) + 0.5F, float(y) + 0.5F);
  const Eigen::Vector2f &a = surface.projected[t[0]], &b = surface.projected[t[1]],
                        &c = surface.projected[t[2]];
  const float area =
      std::abs((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
  const float longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm(), 1e-6F});
  const float room = std::clamp((area / longest) / (5.0F * width) - 0.15F, 0.0F, 1.0F);
  const float distance =
      std::min({height_over(p, a, b), height_over(p, b, c), height_over(p, c, a)});
  return room * std::clamp(0.5F * width + 0.5F - distance, 0.0F, 1.0F);
}

}  // namespace

void paint_surface(const Paint& paint, PaintRow& row) {
  const Surface& surface = *paint.surface;
  const GeometryBuffers& seen = surface.seen;
  const int y = row.y - seen.top;
  if (y < 0 || y >= seen.height) return;
  for (int x = 0; x < seen.width; ++x) {
    const std::size_t i = seen.index(x, y);
    if (seen.id[i] == 0) continue;
    const auto column = std::size_t(x + seen.left);
    if (seen.depth[i] > row.depth[column] + paint.bias) continue;
    Linear colour =
        lit(paint.albedo.empty() ? paint.plain : paint.albedo[i], surface.light[i], paint.evenness);
    float opacity = paint.opacity;
    if (paint.wire > 0.0F && !surface.mesh->is_cloud()) {
      const Triangle& t = surface.mesh->triangles[seen.id[i] - 1];
      const float line = paint.wire * wire_strength(surface, t, x, y, paint.wire_width);
      const float shade = 1.0F - line * (1.0F - kWireShade);
      colour.r *= shade, colour.g *= shade, colour.b *= shade;
      opacity += line * (1.0F - opacity);
    }
    row.colour[column] = over(colour * opacity, row.colour[column]);
    if (paint.opacity >= 1.0F) row.depth[column] = seen.depth[i];
  }
}

}  // namespace regarment
