#include "render/picture.h"

#include <algorithm>
#include <limits>

namespace regarment {
namespace {

struct Range {
  int begin = std::numeric_limits<int>::max(), end = 0;
  void add(int low, int high) { begin = std::min(begin, low), end = std::max(end, high); }
  bool has(int i) const { return begin <= i && i < end; }
};

// The part of the picture, in samples, where anything is painted.
struct Painted {
  Range columns, rows;
};

Painted painted_part(const std::vector<Paint>& paints, const Strokes& lines,
                     const FloorShadow* shadow) {
  Painted part;
  if (lines.left() < lines.right()) {
    part.columns.add(lines.left(), lines.right());
    part.rows.add(lines.top(), lines.bottom());
  }
  for (const Paint& paint : paints) {
    const GeometryBuffers& seen = paint.surface->seen;
    part.columns.add(seen.left, seen.left + seen.width);
    part.rows.add(seen.top, seen.top + seen.height);
  }
  if (shadow == nullptr || shadow->half_height <= 0.0) return part;
  for (int x = 0; x < int(shadow->column.size()); ++x) {
    if (shadow->column[std::size_t(x)] > 0.0F) part.columns.add(x, x + 1);
  }
  part.rows.add(int(shadow->y - shadow->half_height), int(shadow->y + shadow->half_height) + 1);
  return part;
}

void start_row(PaintRow& row, int y, const Range& columns, const FloorShadow* shadow) {
  row.y = y;
  std::fill(row.colour.begin() + columns.begin, row.colour.begin() + columns.end, Linear());
  std::fill(row.depth.begin() + columns.begin, row.depth.begin() + columns.end,
            std::numeric_limits<float>::infinity());
  const float strength = shadow == nullptr ? 0.0F : shadow->strength(y);
  if (strength <= 0.0F) return;
  for (int x = columns.begin; x < columns.end; ++x) {
    row.colour[std::size_t(x)].a = strength * shadow->column[std::size_t(x)];
  }
}

Linear mean_of_samples(const std::vector<PaintRow>& rows, int x) {
  Linear sum;
  for (const PaintRow& row : rows) {
    for (int s = 0; s < kSamples; ++s)
      sum = sum + row.colour[std::size_t(x) * kSamples + std::size_t(s)];
  }
  return sum * (1.0F / (kSamples * kSamples));
}

}  // namespace

Image paint_picture(const Camera& camera, const std::vector<Paint>& paints, const Strokes& lines,
                    const FloorShadow* shadow, Rgba background) {
  Image image(camera.width / kSamples, camera.height / kSamples, background);
  const Painted part = painted_part(paints, lines, shadow);
  const Linear behind =
      linear({background.r, background.g, background.b}, float(background.a) / 255.0F);
  std::vector<PaintRow> rows(kSamples);
  for (PaintRow& row : rows) {
    row.colour.resize(std::size_t(camera.width));
    row.depth.resize(std::size_t(camera.width));
  }
  // Whole pixels, also where the part begins or ends with half of one.
  const Range columns = {part.columns.begin / kSamples * kSamples,
                         std::min((part.columns.end / kSamples + 1) * kSamples, camera.width)};
  for (int y = 0; y < image.height; ++y) {
    if (!part.rows.has(y * kSamples) && !part.rows.has((y + 1) * kSamples - 1)) continue;
    for (int s = 0; s < kSamples; ++s) {
      PaintRow& row = rows[std::size_t(s)];
      start_row(row, y * kSamples + s, columns, shadow);
      for (const Paint& paint : paints) paint_surface(paint, row);
      lines.paint(row);
    }
    for (int x = columns.begin / kSamples; x < columns.end / kSamples; ++x) {
      const Linear mean = mean_of_samples(rows, x);
      if (mean.a > 0.0F) image.at(x, y) = srgb(over(mean, behind));
    }
  }
  return image;
}

}  // namespace regarment
