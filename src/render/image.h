#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Eight bits each of red, green, blue (sRGB) and opacity; not premultiplied.
struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Rgba&) const = default;
};

/// A picture: width x height pixels, row by row, top row first.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgba> pixels;  // width * height

  Image() = default;
  Image(int image_width, int image_height, Rgba fill = {0, 0, 0, 0});
  Rgba& at(int x, int y) { return pixels[std::size_t(y) * width + x]; }
  const Rgba& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
  bool operator==(const Image&) const = default;
};

/// How a picture is stored. `Png` is exact. `WebP` keeps opacity and is the smallest; `Jpeg` lays
/// the picture over white and is the fastest to write.
enum class ImageFormat { Png, Jpeg, WebP };

/// The bytes of an image file. `quality` 1..100 applies to Jpeg and WebP; larger looks better and
/// takes more bytes. Same picture, same bytes. Throws InvalidInput for an empty picture and for
/// sides beyond 16,383 pixels.
std::vector<std::byte> encode_image(const Image& image, ImageFormat format, int quality = 85);

/// Reads the bytes of a PNG, JPEG or WebP file. Throws ReadError when they are no picture; `name`
/// is used in the message.
Image decode_image(std::span<const std::byte> bytes, std::string_view name);

/// Writes a PNG. Throws TemporaryError when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

/// Reads any picture file. Throws ReadError.
Image read_image(const std::filesystem::path& file);

/// Pictures next to each other, tops aligned, `gap` transparent pixels between them.
Image side_by_side(std::span<const Image> images, int gap = 0);

/// The picture `times` smaller, >= 1; each pixel is the mean of those it stands for. What is left
/// over at the right and the bottom is cut off. Throws InvalidInput when nothing is left.
Image shrink(const Image& image, int times);

/// The picture over an opaque background.
Image flatten(const Image& image, Rgba background);

/// How far two pictures are apart.
struct ImageDifference {
  double mean = 0.0;   // mean over pixels and channels of |a - b| / 255, premultiplied by opacity
  double worst = 0.0;  // largest of the same over any single pixel, mean of its channels
  double share = 0.0;  // share of pixels whose difference exceeds 16/255
};

/// The error scale of picture tests. 0 is equal; a shift of the subject by one pixel gives a
/// `share` of about the outline's pixels over all; a picture that is plainly another has a `mean`
/// above 0.02. Throws InvalidInput when the sizes differ.
ImageDifference image_difference(const Image& a, const Image& b);

}  // namespace regarment
