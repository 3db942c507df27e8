#include "render/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/picture.h"

namespace regarment {
namespace {

template <typename Visit>
void for_each_seen(const Surface& surface, Visit visit) {
  const GeometryBuffers& seen = surface.seen;
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      const std::size_t i = seen.index(x, y);
      if (seen.id[i] != 0) visit(i, seen.id[i] - 1, x, y);
    }
  }
}

/// Values of vertices, one per vertex of the original mesh, blended over triangles; 1 everywhere
/// when there are none.
class PixelMeans {
 public:
  PixelMeans(const Surface& surface, std::span<const float> values)
      : surface_(surface), values_(values) {}

  float at(std::uint32_t element, int x, int y) const {
    if (values_.empty()) return 1.0F;
    const DisplayMesh& mesh = *surface_.mesh;
    if (mesh.is_cloud()) return values_[mesh.source_vertex[element]];
    const Triangle& t = mesh.triangles[element];
    const std::array<float, 3> w = surface_.barycentric(t, x, y);
    float sum = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) sum += w[k] * values_[mesh.source_vertex[t[k]]];
    return sum;
  }

 private:
  const Surface& surface_;
  std::span<const float> values_;
};

Colour mix(Colour a, Colour b, int share_of_b, int whole) {
  const auto channel = [&](std::size_t c) {
    return static_cast<std::uint8_t>((a[c] * (whole - share_of_b) + b[c] * share_of_b) / whole);
  };
  return {channel(0), channel(1), channel(2)};
}

Colour blend(const std::array<float, 3>& weight, Colour a, Colour b, Colour c) {
  const auto channel = [&](std::size_t k) {
    const float value = weight[0] * a[k] + weight[1] * b[k] + weight[2] * c[k];
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
  };
  return {channel(0), channel(1), channel(2)};
}

// Largest share first; the smaller label wins a tie.
std::uint8_t strongest(const std::array<float, 3>& weight,
                       const std::array<std::uint8_t, 3>& label) {
  std::uint8_t best = label[0];
  float most = -1.0F;
  for (const std::uint8_t candidate : label) {
    float share = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) share += label[k] == candidate ? weight[k] : 0.0F;
    if (share > most || (share == most && candidate < best)) best = candidate, most = share;
  }
  return best;
}

// Whether another label lies `reach` pixels away along the axes or half as far diagonally.
bool at_border(const GeometryBuffers& seen, std::span<const std::uint8_t> labels, int x, int y,
               int reach) {
  const std::uint8_t own = labels[seen.index(x, y)];
  const auto differs = [&](int dx, int dy) {
    const int u = x + dx, v = y + dy;
    if (u < 0 || v < 0 || u >= seen.width || v >= seen.height) return false;
    const std::uint8_t other = labels[seen.index(u, v)];
    return other != own && other != kNothing;
  };
  const int diagonal = (2 * reach + 1) / 3;
  return differs(reach, 0) || differs(-reach, 0) || differs(0, reach) || differs(0, -reach) ||
         differs(diagonal, diagonal) || differs(-diagonal, diagonal) ||
         differs(diagonal, -diagonal) || differs(-diagonal, -diagonal);
}

}  // namespace

Albedo vertex_albedo(const Surface& surface, std::span<const Colour> colours) {
  Albedo albedo(surface.seen.id.size());
  const DisplayMesh& mesh = *surface.mesh;
  const auto colour_of = [&](std::uint32_t vertex) { return colours[mesh.source_vertex[vertex]]; };
  for_each_seen(surface, [&](std::size_t i, std::uint32_t element, int x, int y) {
    if (mesh.is_cloud()) {
      albedo[i] = colour_of(element);
      return;
    }
    const Triangle& t = mesh.triangles[element];
    albedo[i] =
        blend(surface.barycentric(t, x, y), colour_of(t[0]), colour_of(t[1]), colour_of(t[2]));
  });
  return albedo;
}

Albedo value_albedo(const Surface& surface, std::span<const float> values,
                    const ColourScale& scale) {
  // Looking a colour up is slower than finding its place in a table of them.
  constexpr int kSteps = 1024;
  std::vector<Colour> table;
  for (int i = 0; i <= kSteps; ++i)
    table.push_back(palette_colour(scale.palette, double(i) / kSteps));
  const double per_unit = kSteps / (scale.high - scale.low);
  const auto colour_at = [&](float value) {
    if (std::isnan(value)) return no_data_colour();
    const double place = std::clamp((double(value) - scale.low) * per_unit, 0.0, double(kSteps));
    return table[std::size_t(std::lround(place))];
  };
  Albedo albedo(surface.seen.id.size());
  const PixelMeans means(surface, values);
  for_each_seen(surface, [&](std::size_t i, std::uint32_t element, int x, int y) {
    albedo[i] = colour_at(means.at(element, x, y));
  });
  return albedo;
}

std::vector<std::uint8_t> pixel_labels(const Surface& surface,
                                       std::span<const std::uint8_t> labels) {
  std::vector<std::uint8_t> found(surface.seen.id.size(), kNothing);
  const DisplayMesh& mesh = *surface.mesh;
  const auto label_of = [&](std::uint32_t vertex) {
    return std::min<std::uint8_t>(labels[mesh.source_vertex[vertex]], kNothing - 1);
  };
  for_each_seen(surface, [&](std::size_t i, std::uint32_t element, int x, int y) {
    if (mesh.is_cloud()) {
      found[i] = label_of(element);
      return;
    }
    const Triangle& t = mesh.triangles[element];
    const std::array<std::uint8_t, 3> label = {label_of(t[0]), label_of(t[1]), label_of(t[2])};
    const bool alike = label[0] == label[1] && label[1] == label[2];
    found[i] = alike ? label[0] : strongest(surface.barycentric(t, x, y), label);
  });
  return found;
}

Albedo label_albedo(const Surface& surface, std::span<const std::uint8_t> pixel_labels,
                    const LabelPaint& paint) {
  Albedo albedo(surface.seen.id.size());
  const GeometryBuffers& seen = surface.seen;
  const PixelMeans certainty(surface, paint.probability);
  const Colour border = border_colour();
  const int stripe = 6 * kSamples;
  for_each_seen(surface, [&](std::size_t i, std::uint32_t element, int x, int y) {
    if (!paint.cap.empty() && paint.cap[surface.mesh->source_triangle[element]] != 0) {
      const int across = (x + seen.left + y + seen.top) % stripe;
      albedo[i] = mix(garment_colour(pixel_labels[i]), border, across < stripe / 3 ? 6 : 3, 10);
    } else {
      albedo[i] = label_colour(pixel_labels[i], certainty.at(element, x, y));
    }
    if (paint.borders && at_border(seen, pixel_labels, x, y, kSamples)) albedo[i] = border;
  });
  return albedo;
}

}  // namespace regarment
