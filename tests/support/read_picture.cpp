#include "support/read_picture.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace regarment::test {
namespace {

Image image_from(const cv::Mat& mat) {
  Image image(mat.cols, mat.rows);
  for (int y = 0; y < mat.rows; ++y) {
    for (int x = 0; x < mat.cols; ++x) {
      if (mat.channels() == 4) {
        const auto& v = mat.at<cv::Vec4b>(y, x);
        image.at(x, y) = {v[2], v[1], v[0], v[3]};
      } else {
        const auto& v = mat.at<cv::Vec3b>(y, x);
        image.at(x, y) = {v[2], v[1], v[0], 255};
      }
    }
  }
  return image;
}

}  // namespace

Image read_picture(std::span<const std::byte> bytes) {
  if (bytes.empty()) return {};
  std::vector<unsigned char> buffer(bytes.size());
  std::transform(bytes.begin(), bytes.end(), buffer.begin(),
                 [](std::byte b) { return static_cast<unsigned char>(b); });
  const cv::Mat mat = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  if (mat.empty() || mat.depth() != CV_8U || mat.channels() < 3) return {};
  return image_from(mat);
}

Image read_picture(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return read_picture(std::as_bytes(std::span(text)));
}

}  // namespace regarment::test
