#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "render/image.h"

namespace regarment::test {

/// The picture in the bytes of a PNG, JPEG or WebP file, as OpenCV reads them: a reader that knows
/// nothing of our writer. An empty picture when they are none.
Image read_picture(std::span<const std::byte> bytes);

/// The same of a file.
Image read_picture(const std::filesystem::path& file);

}  // namespace regarment::test
