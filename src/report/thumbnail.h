#pragma once

#include <string>

namespace regarment {

/// A small picture for a page, and its size in pixels.
struct Thumbnail {
  std::string webp;  // bytes
  int width = 0, height = 0;
};

/// Two pictures of one size (bytes of WebP, JPEG or PNG) next to each other, as many times smaller,
/// by a whole number, as brings them to `most_height` pixels or below. Every pixel is the mean of
/// those it stands for. Same pictures, same bytes. Throws ReadError when one is no picture or their
/// heights differ; `name` is used in the message.
Thumbnail make_thumbnail(const std::string& left, const std::string& right, int most_height,
                         const std::string& name);

}  // namespace regarment
