#include "render/image.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"

namespace regarment {
namespace {

Image noise(int width, int height, bool opaque) {
  std::mt19937 random(5);
  Image image(width, height);
  const auto byte = [&] { return static_cast<std::uint8_t>(random() & 255U); };
  for (Rgba& p : image.pixels) {
    p.r = byte(), p.g = byte(), p.b = byte(), p.a = opaque ? std::uint8_t(255) : byte();
  }
  return image;
}

TEST(Image, PngKeepsEveryPixel) {
  for (const bool opaque : {true, false}) {
    const Image image = noise(37, 21, opaque);
    EXPECT_EQ(decode_image(encode_image(image, ImageFormat::Png), "test"), image);
  }
}

TEST(Image, EncodesTheSameBytesEveryTime) {
  const Image image = noise(40, 30, false);
  for (const ImageFormat format : {ImageFormat::Png, ImageFormat::Jpeg, ImageFormat::WebP}) {
    EXPECT_EQ(encode_image(image, format), encode_image(image, format));
  }
}

TEST(Image, JpegLaysThePictureOverWhite) {
  Image image(16, 16);  // nothing at all
  const Image back = decode_image(encode_image(image, ImageFormat::Jpeg, 90), "test");
  for (const Rgba& p : back.pixels) EXPECT_GE(std::min({p.r, p.g, p.b, p.a}), 250);
}

TEST(Image, WebPKeepsOpacity) {
  Image image(16, 16, {200, 30, 30, 255});
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 16; ++y) image.at(x, y) = {0, 0, 0, 0};
  }
  const Image back = decode_image(encode_image(image, ImageFormat::WebP, 90), "test");
  EXPECT_EQ(back.at(2, 8).a, 0);
  EXPECT_EQ(back.at(12, 8).a, 255);
  EXPECT_NEAR(back.at(12, 8).r, 200, 8);
}

TEST(Image, RefusesWhatIsNoPicture) {
  EXPECT_THROW(decode_image({}, "empty.png"), ReadError);
  std::vector<std::byte> bytes = encode_image(noise(20, 20, true), ImageFormat::Png);
  bytes.resize(12);
  EXPECT_THROW(decode_image(bytes, "cut.png"), ReadError);
  for (const ImageFormat format : {ImageFormat::Png, ImageFormat::Jpeg, ImageFormat::WebP}) {
    std::vector<std::byte> half = encode_image(noise(20, 20, true), format);
    half.resize(half.size() / 2);
    EXPECT_THROW(decode_image(half, "half"), ReadError);
  }
  EXPECT_THROW(encode_image(Image(), ImageFormat::Png), InvalidInput);
  EXPECT_THROW(encode_image(Image(20000, 1), ImageFormat::WebP), InvalidInput);
  EXPECT_THROW(encode_image(Image(2, 2), ImageFormat::Jpeg, 0), InvalidInput);
  EXPECT_THROW(read_image("no/such/file.png"), ReadError);
  EXPECT_THROW(write_png(Image(2, 2), "no/such/folder/file.png"), TemporaryError);
}

TEST(ImageDifference, IsZeroForEqualPictures) {
  const Image image = noise(20, 20, false);
  const ImageDifference d = image_difference(image, image);
  EXPECT_EQ(d.mean, 0.0);
  EXPECT_EQ(d.worst, 0.0);
  EXPECT_EQ(d.share, 0.0);
}

TEST(ImageDifference, CountsByHand) {
  Image a(10, 10, {0, 0, 0, 255}), b = a;
  b.at(3, 4) = {255, 255, 255, 255};  // three of four channels differ fully, in one of 100 pixels
  const ImageDifference d = image_difference(a, b);
  EXPECT_DOUBLE_EQ(d.worst, 0.75);
  EXPECT_DOUBLE_EQ(d.mean, 0.0075);
  EXPECT_DOUBLE_EQ(d.share, 0.01);
}

TEST(ImageDifference, DoesNotSeeTheColourOfWhatIsTransparent) {
  const Image a(4, 4, {255, 0, 0, 0}), b(4, 4, {0, 255, 0, 0});
  EXPECT_EQ(image_difference(a, b).mean, 0.0);
}

TEST(ImageDifference, RefusesOtherSizes) {
  EXPECT_THROW(image_difference(Image(2, 3), Image(3, 2)), InvalidInput);
}

TEST(SideBySide, PutsPicturesInARowWithGaps) {
  const std::vector<Image> images = {Image(2, 3, {1, 1, 1, 255}), Image(4, 1, {2, 2, 2, 255})};
  const Image row = side_by_side(images, 5);
  EXPECT_EQ(row.width, 11);
  EXPECT_EQ(row.height, 3);
  EXPECT_EQ(row.at(1, 2).r, 1);
  EXPECT_EQ(row.at(4, 0).a, 0);
  EXPECT_EQ(row.at(7, 0).r, 2);
  EXPECT_EQ(row.at(7, 1).a, 0);
  EXPECT_TRUE(side_by_side({}).pixels.empty());
}

TEST(Shrink, TakesMeansAndCutsOffWhatIsLeft) {
  Image image(5, 4, {0, 0, 0, 255});
  image.at(0, 0) = {100, 40, 8, 255};
  image.at(1, 1) = {20, 0, 80, 255};
  image.at(4, 3) = {255, 255, 255, 255};  // beyond the last whole pixel
  const Image small = shrink(image, 2);
  EXPECT_EQ(small.width, 2);
  EXPECT_EQ(small.height, 2);
  EXPECT_EQ(small.at(0, 0), (Rgba{30, 10, 22, 255}));
  EXPECT_EQ(small.at(1, 1), (Rgba{0, 0, 0, 255}));
  EXPECT_EQ(shrink(image, 1), image);
  EXPECT_THROW(shrink(image, 5), InvalidInput);
}

TEST(Flatten, BlendsByOpacity) {
  const Image flat = flatten(Image(1, 1, {100, 0, 200, 51}), {0, 100, 200, 255});
  EXPECT_EQ(flat.at(0, 0), (Rgba{20, 80, 200, 255}));  // a fifth of the picture
}

}  // namespace
}  // namespace regarment
