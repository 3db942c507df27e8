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

Rgba mean_of(const Image& image, int left, int top, int side) {
  int r = 0, g = 0, b = 0;
  for (int y = top; y < top + side; ++y) {
    for (int x = left; x < left + side; ++x) {
      const Rgba& pixel = image.at(x, y);
      r += pixel.r, g += pixel.g, b += pixel.b;
    }
  }
  const int count = side * side;
  const auto mean = [&](int sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
  return {mean(r), mean(g), mean(b), 255};
}

// What is left over at the right and the bottom is cut off.
Image shrink(const Image& image, int times) {
  Image out(image.width / times, image.height / times);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) out.at(x, y) = mean_of(image, times * x, times * y, times);
  }
  return out;
}

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
