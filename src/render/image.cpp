#include "render/image.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/error.h"

namespace regarment {
namespace {

cv::Mat bgra_from(const Image& image) {
  cv::Mat mat(image.height, image.width, CV_8UC4);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Rgba& p = image.at(x, y);
      mat.at<cv::Vec4b>(y, x) = {p.b, p.g, p.r, p.a};
    }
  }
  return mat;
}

cv::Mat bgr_from(const Image& image) {
  cv::Mat mat(image.height, image.width, CV_8UC3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Rgba& p = image.at(x, y);
      mat.at<cv::Vec3b>(y, x) = {p.b, p.g, p.r};
    }
  }
  return mat;
}

bool opaque(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](Rgba p) { return p.a == 255; });
}

void check_image(const Image& image) {
  const bool fits = image.width > 0 && image.height > 0 &&
                    image.pixels.size() == std::size_t(image.width) * std::size_t(image.height);
  if (!fits) {
    throw InvalidInput("a picture of " + std::to_string(image.width) + " x " +
                       std::to_string(image.height) + " with " +
                       std::to_string(image.pixels.size()) + " pixels cannot be used");
  }
}

Image image_from(const cv::Mat& mat) {
  Image image(mat.cols, mat.rows);
  for (int y = 0; y < mat.rows; ++y) {
    for (int x = 0; x < mat.cols; ++x) {
      Rgba& p = image.at(x, y);
      if (mat.channels() == 4) {
        const auto& v = mat.at<cv::Vec4b>(y, x);
        p = {v[2], v[1], v[0], v[3]};
      } else if (mat.channels() == 3) {
        const auto& v = mat.at<cv::Vec3b>(y, x);
        p = {v[2], v[1], v[0], 255};
      } else {
        const auto v = mat.at<std::uint8_t>(y, x);
        p = {v, v, v, 255};
      }
    }
  }
  return image;
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

std::vector<std::byte> encode_image(const Image& image, ImageFormat format, int quality) {
  check_image(image);
  if (quality < 1 || quality > 100) {
    throw InvalidInput("picture quality " + std::to_string(quality) + " is not in 1..100");
  }
  std::vector<unsigned char> bytes;
  bool good = false;
  switch (format) {
    case ImageFormat::Png:
      // Level 3 takes a third of the time of the default and a few per cent more bytes.
      good = cv::imencode(".png", opaque(image) ? bgr_from(image) : bgra_from(image), bytes,
                          {cv::IMWRITE_PNG_COMPRESSION, 3});
      break;
    case ImageFormat::Jpeg:
      good = cv::imencode(".jpg", bgr_from(flatten(image, {255, 255, 255, 255})), bytes,
                          {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
      break;
    case ImageFormat::WebP:
      good = cv::imencode(".webp", opaque(image) ? bgr_from(image) : bgra_from(image), bytes,
                          {cv::IMWRITE_WEBP_QUALITY, quality});
      break;
  }
  if (!good) throw Error(1, "OpenCV cannot encode a picture; its codecs are missing");
  const auto* begin = reinterpret_cast<const std::byte*>(bytes.data());
  return {begin, begin + bytes.size()};
}

Image decode_image(std::span<const std::byte> bytes, std::string_view name) {
  const std::string broken = std::string(name) + ": not a picture that can be read";
  if (bytes.empty()) throw ReadError(broken);
  std::vector<unsigned char> buffer(bytes.size());
  std::transform(bytes.begin(), bytes.end(), buffer.begin(),
                 [](std::byte b) { return static_cast<unsigned char>(b); });
  try {
    const cv::Mat mat = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    if (mat.empty() || mat.depth() != CV_8U) throw ReadError(broken);
    return image_from(mat);
  } catch (const cv::Exception&) {
    throw ReadError(broken);
  }
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
    for (int y = 0; y < image.height; ++y) {
      std::copy_n(&image.at(0, y), image.width, &row.at(left, y));
    }
    left += image.width + gap;
  }
  return row;
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
