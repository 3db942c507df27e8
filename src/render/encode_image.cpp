#include <jpeglib.h>
#include <png.h>
#include <webp/encode.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <string>

#include "base/error.h"
#include "render/image.h"

namespace regarment {
namespace {

constexpr int kLargest = 16'383;  // pixels, of a WebP; the other formats go further

struct Free {
  void operator()(unsigned char* bytes) const { std::free(bytes); }
};

// Bytes that a C library has allocated.
using Bytes = std::unique_ptr<unsigned char, Free>;

std::vector<std::byte> copied(const unsigned char* bytes, std::size_t size) {
  const auto* begin = reinterpret_cast<const std::byte*>(bytes);
  return {begin, begin + size};
}

bool opaque(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](Rgba p) { return p.a == 255; });
}

// Red, green and blue of each pixel, without the opacity.
std::vector<unsigned char> rgb_of(const Image& image) {
  std::vector<unsigned char> out(3 * image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgba& p = image.pixels[i];
    out[3 * i] = p.r, out[3 * i + 1] = p.g, out[3 * i + 2] = p.b;
  }
  return out;
}

void check_image(const Image& image) {
  const bool fits = image.width > 0 && image.height > 0 && image.width <= kLargest &&
                    image.height <= kLargest &&
                    image.pixels.size() == std::size_t(image.width) * std::size_t(image.height);
  if (!fits) {
    throw InvalidInput("a picture of " + std::to_string(image.width) + " x " +
                       std::to_string(image.height) + " with " +
                       std::to_string(image.pixels.size()) + " pixels cannot be used");
  }
}

struct JpegFailure {
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

[[noreturn]] void fail_jpeg(j_common_ptr info) {
  std::longjmp(reinterpret_cast<JpegFailure*>(info->err)->back, 1);
}

// Holds nothing that needs a destructor, as libjpeg leaves it by a jump. False: out of memory.
bool compress_jpeg(const unsigned char* rgb, int width, int height, int quality,
                   unsigned char** out, unsigned long* size) {
  jpeg_compress_struct info;
  JpegFailure failure;
  info.err = jpeg_std_error(&failure.manager);
  failure.manager.error_exit = fail_jpeg;
  if (setjmp(failure.back) != 0) {
    jpeg_destroy_compress(&info);
    return false;
  }
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, out, size);
  info.image_width = static_cast<JDIMENSION>(width);
  info.image_height = static_cast<JDIMENSION>(height);
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  info.optimize_coding = TRUE;
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    // libjpeg takes rows it does not write to as if it did.
    auto* row = const_cast<unsigned char*>(rgb) + std::size_t(3) * width * info.next_scanline;
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  return true;
}

std::vector<std::byte> jpeg_of(const Image& image, int quality) {
  const std::vector<unsigned char> rgb = rgb_of(flatten(image, {255, 255, 255, 255}));
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const bool good = compress_jpeg(rgb.data(), image.width, image.height, quality, &bytes, &size);
  const Bytes owner(bytes);
  if (!good) throw std::bad_alloc();
  return copied(bytes, size);
}

std::vector<std::byte> png_of(const Image& image) {
  const bool plain = opaque(image);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = plain ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const std::vector<unsigned char> rgb = plain ? rgb_of(image) : std::vector<unsigned char>();
  const void* pixels =
      plain ? static_cast<const void*>(rgb.data()) : static_cast<const void*>(image.pixels.data());
  std::vector<std::byte> out(PNG_IMAGE_PNG_SIZE_MAX(header));
  png_alloc_size_t size = out.size();
  const int good = png_image_write_to_memory(&header, out.data(), &size, 0, pixels, 0, nullptr);
  if (good == 0) throw Error(1, std::string("a picture cannot be encoded: ") + header.message);
  out.resize(size);
  return out;
}

std::vector<std::byte> webp_of(const Image& image, int quality) {
  const auto* pixels = reinterpret_cast<const unsigned char*>(image.pixels.data());
  const auto good_as = static_cast<float>(quality);
  unsigned char* bytes = nullptr;
  std::size_t size = 0;
  if (opaque(image)) {
    size = WebPEncodeRGB(rgb_of(image).data(), image.width, image.height, 3 * image.width, good_as,
                         &bytes);
  } else {
    size = WebPEncodeRGBA(pixels, image.width, image.height, 4 * image.width, good_as, &bytes);
  }
  const Bytes owner(bytes);
  if (size == 0) throw std::bad_alloc();
  return copied(bytes, size);
}

}  // namespace

std::vector<std::byte> encode_image(const Image& image, ImageFormat format, int quality) {
  static_assert(sizeof(Rgba) == 4, "pixels are handed on as they lie");
  check_image(image);
  if (quality < 1 || quality > 100) {
    throw InvalidInput("picture quality " + std::to_string(quality) + " is not in 1..100");
  }
  switch (format) {
    case ImageFormat::Png:
      return png_of(image);
    case ImageFormat::Jpeg:
      return jpeg_of(image, quality);
    case ImageFormat::WebP:
      return webp_of(image, quality);
  }
  throw InvalidInput("unknown picture format " + std::to_string(int(format)));
}

void write_png(const Image& image, const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = encode_image(image, ImageFormat::Png);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  out.close();
  if (!out)
    throw TemporaryError("cannot write " + file.string() + "; is there room and permission?");
}

}  // namespace regarment
