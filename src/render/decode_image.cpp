#include <jpeglib.h>
#include <png.h>
#include <webp/decode.h>

#include <csetjmp>
#include <cstring>
#include <memory>
#include <string>

#include "base/error.h"
#include "render/image.h"

namespace regarment {
namespace {

constexpr std::size_t kMostPixels = std::size_t{1} << 26U;

struct JpegFailure {
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

[[noreturn]] void fail_jpeg(j_common_ptr info) {
  std::longjmp(reinterpret_cast<JpegFailure*>(info->err)->back, 1);
}

void say_nothing(j_common_ptr /*info*/, int /*level*/) {}

// Takes the pixels of a picture row by row; libjpeg may end it by a jump.
struct JpegReader {
  jpeg_decompress_struct info{};
  JpegFailure failure{};

  JpegReader() {
    info.err = jpeg_std_error(&failure.manager);
    failure.manager.error_exit = fail_jpeg;
    failure.manager.emit_message = say_nothing;
  }
  ~JpegReader() { jpeg_destroy_decompress(&info); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  // These hold nothing that needs a destructor. False: no JPEG.
  bool begin(const unsigned char* bytes, std::size_t size) {
    if (setjmp(failure.back) != 0) return false;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, bytes, size);
    jpeg_read_header(&info, TRUE);
    info.out_color_space = JCS_RGB;
    jpeg_start_decompress(&info);
    return info.output_components == 3;
  }
  bool read(unsigned char* row) {
    if (setjmp(failure.back) != 0) return false;
    return jpeg_read_scanlines(&info, &row, 1) == 1;
  }
};

bool fits(std::size_t width, std::size_t height) {
  return width > 0 && height > 0 && width <= kMostPixels / height;
}

// Each of these gives an empty picture for what it cannot read.

Image from_jpeg(const unsigned char* bytes, std::size_t size) {
  JpegReader reader;
  if (!reader.begin(bytes, size)) return {};
  const std::size_t width = reader.info.output_width, height = reader.info.output_height;
  if (!fits(width, height)) return {};
  Image image(static_cast<int>(width), static_cast<int>(height));
  std::vector<unsigned char> row(3 * width);
  for (int y = 0; y < image.height; ++y) {
    if (!reader.read(row.data())) return {};
    const unsigned char* c = row.data();
    for (int x = 0; x < image.width; ++x, c += 3) image.at(x, y) = {c[0], c[1], c[2], 255};
  }
  return image;
}

Image from_png(const unsigned char* bytes, std::size_t size) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> owner(&header, png_image_free);
  if (png_image_begin_read_from_memory(&header, bytes, size) == 0) return {};
  if (!fits(header.width, header.height)) return {};
  header.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  if (png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr) == 0) return {};
  return image;
}

Image from_webp(const unsigned char* bytes, std::size_t size) {
  int width = 0, height = 0;
  if (WebPGetInfo(bytes, size, &width, &height) == 0) return {};
  if (!fits(static_cast<std::size_t>(width), static_cast<std::size_t>(height))) return {};
  Image image(width, height);
  auto* pixels = reinterpret_cast<unsigned char*>(image.pixels.data());
  if (WebPDecodeRGBAInto(bytes, size, pixels, 4 * image.pixels.size(), 4 * width) == nullptr)
    return {};
  return image;
}

}  // namespace

Image decode_image(std::span<const std::byte> bytes, std::string_view name) {
  static_assert(sizeof(Rgba) == 4, "pixels are taken as they lie");
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto begins = [&](std::string_view magic) {
    return bytes.size() > magic.size() && std::memcmp(data, magic.data(), magic.size()) == 0;
  };
  Image image;
  if (begins("\xFF\xD8")) image = from_jpeg(data, bytes.size());
  if (begins("\x89PNG")) image = from_png(data, bytes.size());
  if (begins("RIFF")) image = from_webp(data, bytes.size());
  if (image.pixels.empty()) {
    throw ReadError(std::string(name) + ": not a picture that can be read");
  }
  return image;
}

}  // namespace regarment
