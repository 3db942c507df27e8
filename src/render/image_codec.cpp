#include <png.h>
#include <turbojpeg.h>
#include <webp/decode.h>
#include <webp/encode.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "render/image.h"

namespace regarment {
namespace {

using Bytes = std::span<const unsigned char>;

constexpr int kMostSide = 16383;  // pixels, as far as WebP goes
constexpr int kChannels = 4;

const unsigned char* channels(const Image& image) {
  static_assert(sizeof(Rgba) == kChannels);
  return reinterpret_cast<const unsigned char*>(image.pixels.data());
}

unsigned char* channels(Image& image) {
  return reinterpret_cast<unsigned char*>(image.pixels.data());
}

bool opaque(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](Rgba p) { return p.a == 255; });
}

std::vector<unsigned char> without_opacity(const Image& image) {
  std::vector<unsigned char> out;
  out.reserve(3 * image.pixels.size());
  for (const Rgba& p : image.pixels) out.insert(out.end(), {p.r, p.g, p.b});
  return out;
}

void check_image(const Image& image) {
  const bool fits = image.width > 0 && image.height > 0 && image.width <= kMostSide &&
                    image.height <= kMostSide &&
                    image.pixels.size() == std::size_t(image.width) * std::size_t(image.height);
  if (!fits) {
    throw InvalidInput("a picture of " + std::to_string(image.width) + " x " +
                       std::to_string(image.height) + " with " +
                       std::to_string(image.pixels.size()) + " pixels cannot be used");
  }
}

[[noreturn]] void throw_not_encoded(const char* format) {
  throw Error(1, std::string("a picture cannot be written as ") + format);
}

std::vector<std::byte> copy_of(Bytes bytes) {
  const auto view = std::as_bytes(bytes);
  return {view.begin(), view.end()};
}

// Nothing where the bytes are no such picture.
using Decoded = std::optional<Image>;

std::vector<std::byte> encode_png(const Image& image) {
  png_image head{};
  head.version = PNG_IMAGE_VERSION;
  head.width = static_cast<png_uint_32>(image.width);
  head.height = static_cast<png_uint_32>(image.height);
  const bool plain = opaque(image);
  head.format = plain ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const std::vector<unsigned char> three =
      plain ? without_opacity(image) : std::vector<unsigned char>{};
  const unsigned char* pixels = plain ? three.data() : channels(image);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(head);
  std::vector<unsigned char> bytes(size);
  if (png_image_write_to_memory(&head, bytes.data(), &size, 0, pixels, 0, nullptr) == 0)
    throw_not_encoded("PNG");
  return copy_of(Bytes(bytes).first(size));
}

Decoded decode_png(Bytes bytes) {
  png_image head{};
  head.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&head, bytes.data(), bytes.size()) == 0) return {};
  if (head.width > kMostSide || head.height > kMostSide) {
    png_image_free(&head);
    return {};
  }
  head.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(head.width), static_cast<int>(head.height));
  if (png_image_finish_read(&head, nullptr, channels(image), 0, nullptr) == 0) return {};
  return image;
}

struct FreeJpeg {
  void operator()(void* codec) const { tjDestroy(codec); }
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};
using JpegCodec = std::unique_ptr<void, FreeJpeg>;

std::vector<std::byte> encode_jpeg(const Image& image, int quality) {
  const Image flat = flatten(image, {255, 255, 255, 255});
  const JpegCodec codec(tjInitCompress());
  unsigned char* data = nullptr;
  unsigned long size = 0;
  const bool good =
      codec && tjCompress2(codec.get(), channels(flat), flat.width, 0, flat.height, TJPF_RGBX,
                           &data, &size, TJSAMP_420, quality, TJFLAG_ACCURATEDCT) == 0;
  const std::unique_ptr<unsigned char, FreeJpeg> owned(data);
  if (!good) throw_not_encoded("JPEG");
  return copy_of({data, size});
}

Decoded decode_jpeg(Bytes bytes) {
  const JpegCodec codec(tjInitDecompress());
  int width = 0, height = 0, sampling = 0, colours = 0;
  const auto size = static_cast<unsigned long>(bytes.size());
  if (!codec || tjDecompressHeader3(codec.get(), bytes.data(), size, &width, &height, &sampling,
                                    &colours) != 0) {
    return {};
  }
  if (width > kMostSide || height > kMostSide) return {};
  Image image(width, height);
  if (tjDecompress2(codec.get(), bytes.data(), size, channels(image), width, 0, height, TJPF_RGBA,
                    TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING) != 0) {
    return {};
  }
  return image;
}

struct FreeWebP {
  void operator()(unsigned char* bytes) const { WebPFree(bytes); }
};

std::vector<std::byte> encode_webp(const Image& image, int quality) {
  unsigned char* data = nullptr;
  std::size_t size = 0;
  const auto level = static_cast<float>(quality);
  if (opaque(image)) {
    const std::vector<unsigned char> three = without_opacity(image);
    size = WebPEncodeRGB(three.data(), image.width, image.height, 3 * image.width, level, &data);
  } else {
    size = WebPEncodeRGBA(channels(image), image.width, image.height, kChannels * image.width,
                          level, &data);
  }
  const std::unique_ptr<unsigned char, FreeWebP> owned(data);
  if (size == 0) throw_not_encoded("WebP");
  return copy_of({data, size});
}

Decoded decode_webp(Bytes bytes) {
  int width = 0, height = 0;
  if (WebPGetInfo(bytes.data(), bytes.size(), &width, &height) == 0) return {};
  Image image(width, height);
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), channels(image),
                         kChannels * image.pixels.size(), kChannels * width) == nullptr) {
    return {};
  }
  return image;
}

}  // namespace

std::vector<std::byte> encode_image(const Image& image, ImageFormat format, int quality) {
  check_image(image);
  if (quality < 1 || quality > 100) {
    throw InvalidInput("picture quality " + std::to_string(quality) + " is not in 1..100");
  }
  switch (format) {
    case ImageFormat::Png:
      return encode_png(image);
    case ImageFormat::Jpeg:
      return encode_jpeg(image, quality);
    case ImageFormat::WebP:
      return encode_webp(image, quality);
  }
  return {};
}

Image decode_image(std::span<const std::byte> bytes, std::string_view name) {
  const Bytes data(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  for (const auto decode : {decode_png, decode_jpeg, decode_webp}) {
    if (Decoded image = decode(data)) return std::move(*image);
  }
  throw ReadError(std::string(name) + ": not a picture that can be read");
}

}  // namespace regarment
