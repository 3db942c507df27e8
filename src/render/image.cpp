#include "render/image.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <opencv2/imgproc.hpp>

#include "base/error.h"

namespace regarment {
namespace {

// Its pixels as OpenCV sees them; no copy.
cv::Mat mat_of(Image& image) { return {image.height, image.width, CV_8UC4, image.pixels.data()}; }

cv::Mat mat_of(const Image& image) {
  return {image.height, image.width, CV_8UC4, const_cast<Rgba*>(image.pixels.data())};
}

std::uint8_t blend(std::uint8_t over, std::uint8_t under, int alpha) {
  return static_cast<std::uint8_t>((over * alpha + under * (255 - alpha) + 127) / 255);
}

}  // namespace

Image::Image(int image_width, int image_height, Rgba fill)
    : width(image_width),
      height(image_height),
      pixels(std::size_t(std::max(image_width, 0)) * std::size_t(std::max(image_height, 0)), fill) {
}

void write_png(const Image& image, const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = encode_image(image, ImageFormat::Png);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  out.close();
  if (!out)
    throw TemporaryError("cannot write " + file.string() + "; is there room and permission?");
}

Image read_image(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ReadError("cannot open " + file.string());
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return decode_image(std::as_bytes(std::span(text)), file.filename().string());
}

Image side_by_side(std::span<const Image> images, int gap) {
  int width = 0, height = 0;
  for (const Image& image : images) {
    width += image.width + (width > 0 ? gap : 0);
    height = std::max(height, image.height);
  }
  Image row(width, height);
  int left = 0;
  for (const Image& image : images) {
    if (!image.pixels.empty())
      mat_of(image).copyTo(mat_of(row)({left, 0, image.width, image.height}));
    left += image.width + gap;
  }
  return row;
}

Image shrink(const Image& image, int times) {
  Image out(image.width / times, image.height / times);
  if (out.pixels.empty())
    throw InvalidInput("a picture is too small to be shrunk " + std::to_string(times) + " times");
  const cv::Rect whole(0, 0, times * out.width, times * out.height);
  cv::Mat into = mat_of(out);
  cv::resize(mat_of(image)(whole), into, into.size(), 0, 0, cv::INTER_AREA);
  return out;
}

Image flatten(const Image& image, Rgba background) {
  Image flat = image;
  for (Rgba& p : flat.pixels) {
    if (p.a == 255) continue;
    p = {blend(p.r, background.r, p.a), blend(p.g, background.g, p.a),
         blend(p.b, background.b, p.a), 255};
  }
  return flat;
}

ImageDifference image_difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) {
    throw InvalidInput("pictures of " + std::to_string(a.width) + " x " + std::to_string(a.height) +
                       " and " + std::to_string(b.width) + " x " + std::to_string(b.height) +
                       " cannot be compared");
  }
  ImageDifference difference;
  std::size_t visible = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgba &p = a.pixels[i], &q = b.pixels[i];
    const auto channel = [&](int u, int v) {
      return std::abs(u * p.a - v * q.a) / (255.0 * 255.0);
    };
    const double here = 0.25 * (channel(p.r, q.r) + channel(p.g, q.g) + channel(p.b, q.b) +
                                std::abs(p.a - q.a) / 255.0);
    difference.mean += here;
    difference.worst = std::max(difference.worst, here);
    if (here > 16.0 / 255.0) ++visible;
  }
  const double count = double(std::max<std::size_t>(a.pixels.size(), 1));
  difference.mean /= count;
  difference.share = double(visible) / count;
  return difference;
}

}  // namespace regarment
