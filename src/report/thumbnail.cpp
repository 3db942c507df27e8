#include "report/thumbnail.h"

#include <array>
#include <cstddef>
#include <span>

#include "base/error.h"
#include "render/image.h"

namespace regarment {
namespace {

constexpr int kGap = 6, kQuality = 78;
constexpr Rgba kGround = {236, 238, 239, 255};  // that of the reports' pictures

}  // namespace

Thumbnail make_thumbnail(const std::string& left, const std::string& right, int most_height,
                         const std::string& name) {
  std::array<Image, 2> sides = {decode_image(std::as_bytes(std::span(left)), name),
                                decode_image(std::as_bytes(std::span(right)), name)};
  const int height = sides[0].height;
  const int times = (height + most_height - 1) / most_height;
  for (Image& side : sides) {
    if (side.height != height || side.width < times) {
      throw ReadError(name + ": the pictures of its sides differ in size; fit the scan again");
    }
    side = shrink(flatten(side, kGround), times);
  }
  const Image both = flatten(side_by_side(sides, kGap), kGround);
  Thumbnail out{{}, both.width, both.height};
  for (const std::byte byte : encode_image(both, ImageFormat::WebP, kQuality)) {
    out.webp += static_cast<char>(byte);
  }
  return out;
}

}  // namespace regarment
