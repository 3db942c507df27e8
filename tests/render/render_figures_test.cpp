#include "render/render_figures.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "base/error.h"
#include "render/shapes.h"

namespace regarment {
namespace {

const std::vector<Look> kAllLooks = {Look::Scan,      Look::Clay,  Look::Segmentation,
                                     Look::Placement, Look::Drape, Look::Deviation};

// A figure in a skirt with everything a scene can have.
struct Dressed {
  Mesh scan = test::mannequin();
  std::vector<std::uint8_t> labels;
  std::vector<float> values;
  std::vector<std::uint8_t> cap;
  Mesh draped = test::skirt_mesh(1.0, 0.5, 0.2, 0.26);
  Mesh placed = test::skirt_mesh(1.0, 0.5, 0.28, 0.34);

  Dressed() {
    for (const Vec3& p : scan.positions) {
      labels.push_back(p.y() > 0.5 && p.y() < 1.0 && std::abs(p.x()) < 0.24 ? 1 : 0);
      values.push_back(p.y() < 0.2 ? std::nanf("") : float(0.02 * (p.y() - 0.85)));
    }
    for (const Triangle& t : scan.triangles) cap.push_back(scan.positions[t[0]].y() > 1.6 ? 1 : 0);
  }

  Scene scene() const {
    return {scan, labels, values,
            cap,  {},     {{draped.triangles, placed.positions, draped.positions, 1}}};
  }
};

FigureOptions small(View view, int size = 256) {
  FigureOptions options;
  options.framing.width = options.framing.height = size;
  options.views = {view};
  options.background = {255, 255, 255, 255};
  return options;
}

Image draw(const Scene& scene, Look look, const FigureOptions& options) {
  return render_figures(scene, std::vector<Look>{look}, options).front().image;
}

Scene bare(const Mesh& mesh) { return {mesh, {}, {}, {}, {}, {}}; }

class Baseline : public testing::TestWithParam<Look> {};

// The picture made stays in the build folder, to be looked at before it becomes a baseline.
TEST_P(Baseline, IsWhatTheFigureLooksLike) {
  const std::string name = "figure-" + std::string(look_name(GetParam())) + ".png";
  const Dressed dressed;
  const Image made = draw(dressed.scene(), GetParam(), small(View::FrontLeft));
  write_png(made, std::filesystem::path(REGARMENT_MADE_PICTURES) / name);
  const Image baseline = read_image(std::filesystem::path(REGARMENT_BASELINES) / name);
  const ImageDifference difference = image_difference(made, baseline);
  EXPECT_LT(difference.mean, 0.002);   // a tenth of what a plainly different picture has
  EXPECT_LT(difference.share, 0.005);  // the outline alone is four times as much
}

INSTANTIATE_TEST_SUITE_P(Looks, Baseline,
                         testing::Values(Look::Clay, Look::Segmentation, Look::Placement,
                                         Look::Drape, Look::Deviation),
                         [](const auto& test) { return std::string(look_name(test.param)); });

TEST(RenderFigures, OrdersByLookThenView) {
  const Dressed dressed;
  FigureOptions options = small(View::Front, 32);
  options.views = {View::Back, View::Left};
  const auto figures =
      render_figures(dressed.scene(), std::vector<Look>{Look::Drape, Look::Clay}, options);
  ASSERT_EQ(figures.size(), 4U);
  EXPECT_EQ(figures[1].look, Look::Drape);
  EXPECT_EQ(figures[1].view, View::Left);
  EXPECT_EQ(figures[2].look, Look::Clay);
  EXPECT_EQ(figures[2].view, View::Back);
}

TEST(RenderFigures, SameBytesAgainAndInOtherThreads) {
  const Dressed dressed;
  Mesh cloud = dressed.scan;
  cloud.triangles.clear();
  FigureOptions options = small(View::Right, 128);
  for (const Mesh& scan : {dressed.scan, cloud}) {
    Scene scene = {scan, dressed.labels, dressed.values, {}, {}, dressed.scene().garments};
    const auto figures = [&] {
      std::vector<Image> images;
      for (Figure& f : render_figures(scene, kAllLooks, options)) images.push_back(f.image);
      return images;
    };
    const std::vector<Image> first = figures();
    EXPECT_EQ(first, figures());
    std::vector<Image> one, two;
    std::thread other([&] { one = figures(); });
    std::thread third([&] { two = figures(); });
    other.join();
    third.join();
    EXPECT_EQ(first, one);
    EXPECT_EQ(first, two);
  }
}

TEST(RenderFigures, LooksOfOneViewMatchPixelForPixel) {
  Dressed dressed;
  FigureOptions options = small(View::Front, 200);
  options.background = {0, 0, 0, 0};
  const Image clay = draw(dressed.scene(), Look::Clay, options);
  for (const Look look : {Look::Scan, Look::Segmentation, Look::Deviation}) {
    const Image other = draw(dressed.scene(), look, options);
    for (std::size_t i = 0; i < clay.pixels.size(); ++i) {
      ASSERT_EQ(clay.pixels[i].a, other.pixels[i].a) << look_name(look) << " pixel " << i;
    }
  }
}

TEST(RenderFigures, ALookWithoutItsDataShowsTheScanAlone) {
  const Mesh mesh = test::mannequin();
  const Image clay = draw(bare(mesh), Look::Clay, small(View::Front, 100));
  for (const Look look : {Look::Scan, Look::Segmentation, Look::Placement, Look::Drape}) {
    EXPECT_EQ(draw(bare(mesh), look, small(View::Front, 100)), clay) << look_name(look);
  }
}

TEST(RenderFigures, BackgroundShowsWhereNothingStands) {
  const Mesh mesh = test::sphere_mesh(1.0, 20);
  FigureOptions options = small(View::Front, 64);
  options.shadow = false;
  options.background = {10, 20, 30, 255};
  EXPECT_EQ(draw(bare(mesh), Look::Clay, options).at(1, 1), (Rgba{10, 20, 30, 255}));
  options.background = {0, 0, 0, 0};
  const Image cut = draw(bare(mesh), Look::Clay, options);
  EXPECT_EQ(cut.at(1, 1).a, 0);
  EXPECT_EQ(cut.at(32, 32).a, 255);
}

bool bluish(const Rgba& p) { return p.b > p.r + 30; }
bool dark(const Rgba& p) { return std::max({p.r, p.g, p.b}) < 90; }

TEST(RenderFigures, SegmentationColoursTheGarmentAndDrawsItsBorder) {
  const Mesh mesh = test::sphere_mesh(1.0, 60);
  std::vector<std::uint8_t> labels;
  for (const Vec3& p : mesh.positions) labels.push_back(p.y() < 0.0 ? 1 : 0);
  const Scene scene = {mesh, labels, {}, {}, {}, {}};
  const Image image = draw(scene, Look::Segmentation, small(View::Front, 200));
  EXPECT_FALSE(bluish(image.at(100, 60)));
  EXPECT_TRUE(bluish(image.at(100, 140)));
  int darkest = 255;
  for (int y = 90; y < 112; ++y) darkest = std::min<int>(darkest, image.at(100, y).b);
  EXPECT_LT(darkest, 110);  // the line is about two pixels wide
  EXPECT_FALSE(dark(image.at(100, 60)));
}

TEST(RenderFigures, BorderLinesTakeThePlaceOfLinesBetweenLabels) {
  const Mesh mesh = test::sphere_mesh(1.0, 60);
  std::vector<std::uint8_t> labels;
  for (const Vec3& p : mesh.positions) labels.push_back(p.y() < 0.0 ? 1 : 0);
  std::vector<Vec3> ring;  // a little above where the labels meet
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * M_PI * i / 100;
    ring.emplace_back(std::sqrt(0.96) * std::cos(angle), 0.2, std::sqrt(0.96) * std::sin(angle));
  }
  Scene scene = {mesh, labels, {}, {}, {}, {}};
  scene.border_lines = {ring};
  const Image image = draw(scene, Look::Segmentation, small(View::Front, 200));
  const auto darkest = [&](int from, int to) {
    int out = 255;
    for (int y = from; y < to; ++y) out = std::min<int>(out, image.at(100, y).b);
    return out;
  };
  EXPECT_LT(darkest(78, 86), 110);   // 0.2 of the radius above the middle, at row 100
  EXPECT_GT(darkest(90, 110), 110);  // where the labels meet
  EXPECT_EQ(draw(scene, Look::Clay, small(View::Front, 200)),
            draw(bare(mesh), Look::Clay, small(View::Front, 200)));
}

TEST(RenderFigures, UnsureLabelsAreShaded) {
  const Mesh mesh = test::sphere_mesh(1.0, 60);
  const std::vector<std::uint8_t> labels(mesh.positions.size(), 1);
  std::vector<float> probability;
  for (const Vec3& p : mesh.positions) probability.push_back(p.y() < 0.0 ? 0.5F : 1.0F);
  Scene scene = {mesh, labels, {}, {}, {}, {}};
  scene.probability = probability;
  const Image image = draw(scene, Look::Segmentation, small(View::Front, 200));
  EXPECT_TRUE(bluish(image.at(100, 60)));
  EXPECT_GT(image.at(100, 140).r, image.at(100, 140).b + 30);
  const std::vector<float> few(3, 1.0F);
  scene.probability = few;
  EXPECT_THROW(draw(scene, Look::Segmentation, small(View::Front, 32)), InvalidInput);
}

TEST(RenderFigures, CapsAreStriped) {
  const Mesh mesh = test::sphere_mesh(1.0, 60);
  const std::vector<std::uint8_t> labels(mesh.positions.size(), 0);
  const std::vector<std::uint8_t> caps(mesh.triangles.size(), 1);
  const Image plain =
      draw({mesh, labels, {}, {}, {}, {}}, Look::Segmentation, small(View::Front, 200));
  const Image striped =
      draw({mesh, labels, {}, caps, {}, {}}, Look::Segmentation, small(View::Front, 200));
  int turns = 0, last = 0;
  for (int x = 70; x < 130; ++x) {
    const int fall = plain.at(x, 100).r - striped.at(x, 100).r;
    EXPECT_GT(fall, 20);  // dimmed everywhere
    const int sign = fall > 80 ? 1 : -1;
    if (sign != last) ++turns;
    last = sign;
  }
  EXPECT_GT(turns, 6);  // and striped
}

TEST(RenderFigures, ClothInFrontHidesAndClothBehindIsHidden) {
  const Mesh wall = test::box_mesh({-1, -1, -0.1}, {1, 1, 0.1});
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto sheet = [](double z) {
    return std::vector<Vec3>{{-0.5, -0.5, z}, {0.5, -0.5, z}, {0.5, 0.5, z}, {-0.5, 0.5, z}};
  };
  const auto middle = [&](double z, Look look) {
    const std::vector<Vec3> positions = sheet(z);
    const Scene scene = {wall, {}, {}, {}, {}, {{triangles, positions, positions, 1}}};
    return draw(scene, look, small(View::Front, 101)).at(45, 61);
  };
  for (const Look look : {Look::Placement, Look::Drape}) {
    EXPECT_TRUE(bluish(middle(0.3, look))) << look_name(look);
    EXPECT_FALSE(bluish(middle(-0.3, look))) << look_name(look);
  }
  // Within two centimetres of the scan's own surface a draped garment is what is shown.
  EXPECT_TRUE(bluish(middle(0.09, Look::Drape)));
  EXPECT_FALSE(bluish(middle(0.09, Look::Placement)));
}

TEST(RenderFigures, OutermostGarmentIsOnTop) {
  const Mesh wall = test::box_mesh({-1, -1, -0.1}, {1, 1, 0.1});
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Vec3> sheet = {
      {-0.5, -0.5, 0.11}, {0.5, -0.5, 0.11}, {0.5, 0.5, 0.11}, {-0.5, 0.5, 0.11}};
  const Scene scene = {wall, {}, {},
                       {},   {}, {{triangles, {}, sheet, 1}, {triangles, {}, sheet, 2}}};
  EXPECT_TRUE(bluish(draw(scene, Look::Drape, small(View::Front, 101)).at(50, 50)));
}

TEST(RenderFigures, DeviationIsGreyWithoutDataAndColouredBySign) {
  const Mesh wall = test::box_mesh({-1, -1, -0.1}, {1, 1, 0.1});
  const auto middle = [&](float value) {
    const std::vector<float> values(wall.positions.size(), value);
    return draw({wall, {}, values, {}, {}, {}}, Look::Deviation, small(View::Front, 101))
        .at(50, 50);
  };
  EXPECT_TRUE(bluish(middle(-0.008F)));
  EXPECT_GT(middle(0.008F).r, middle(0.008F).b + 30);
  const Rgba none = middle(std::nanf(""));
  EXPECT_LT(std::abs(none.r - none.b), 12);
  EXPECT_LT(none.r, middle(0.0F).r - 20);
}

TEST(RenderFigures, ScanShowsItsOwnColours) {
  Mesh mesh = test::sphere_mesh(1.0, 40);
  mesh.colours.assign(mesh.positions.size(), {20, 200, 20});
  const Rgba own = draw(bare(mesh), Look::Scan, small(View::Front, 64)).at(32, 32);
  EXPECT_GT(own.g, own.r + 60);
  const Rgba clay = draw(bare(mesh), Look::Clay, small(View::Front, 64)).at(32, 32);
  EXPECT_LT(std::abs(clay.g - clay.r), 20);
}

TEST(RenderFigures, ASymmetricFigureHasSymmetricOutlines) {
  const Mesh mesh = test::mannequin();
  FigureOptions options = small(View::Front, 200);
  options.background = {0, 0, 0, 0};
  options.shadow = false;
  const Image image = draw(bare(mesh), Look::Clay, options);
  int different = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 100; ++x) {
      if (std::abs(image.at(x, y).a - image.at(199 - x, y).a) > 64) ++different;
    }
  }
  EXPECT_EQ(different, 0);  // a sample of the four on an edge may fall either way
}

TEST(RenderFigures, OutliersNeitherShowNorStretchTheFrame) {
  const Mesh mesh = test::sphere_mesh(1.0, 20);
  Mesh with_stray = mesh;
  with_stray.positions.emplace_back(50, 0, 0);
  with_stray.normals.emplace_back(1, 0, 0);
  std::vector<std::uint8_t> outlier(mesh.positions.size(), 0);
  outlier.push_back(1);
  const FigureOptions options = small(View::Front, 80);
  EXPECT_EQ(draw({with_stray, {}, {}, {}, outlier, {}}, Look::Clay, options),
            draw(bare(mesh), Look::Clay, options));
}

TEST(RenderFigures, ScaleBarIsTwentyCentimetresLong) {
  const Mesh mesh = test::box_mesh({-0.5, 0, -0.5}, {0.5, 1, 0.5});
  FigureOptions options = small(View::Front, 400);
  options.shadow = false;
  options.scale_bar = true;
  const Image with = draw(bare(mesh), Look::Clay, options);
  options.scale_bar = false;
  const Image without = draw(bare(mesh), Look::Clay, options);
  int low = 400, high = -1;
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) {
      if (with.at(x, y) != without.at(x, y)) low = std::min(low, x), high = std::max(high, x);
    }
  }
  const double pixels_per_metre = 400 * (1 - 2 * 0.03);  // a box of one metre and the margin
  EXPECT_NEAR(high - low + 1, 0.2 * pixels_per_metre, 1.0);
}

TEST(RenderFigures, RefusesWhatDoesNotFit) {
  const Mesh mesh = test::sphere_mesh(1.0, 10);
  const std::vector<std::uint8_t> few(3, 0);
  const FigureOptions options = small(View::Front, 32);
  EXPECT_THROW(draw({mesh, few, {}, {}, {}, {}}, Look::Scan, options), InvalidInput);
  EXPECT_THROW(draw({mesh, {}, {}, few, {}, {}}, Look::Scan, options), InvalidInput);
  const std::vector<std::uint8_t> all(mesh.positions.size(), 1);
  EXPECT_THROW(draw({mesh, {}, {}, {}, all, {}}, Look::Scan, options), InvalidInput);
  EXPECT_THROW(draw(bare(Mesh()), Look::Scan, options), InvalidInput);
  FigureOptions no_views = options;
  no_views.views.clear();
  EXPECT_THROW(draw(bare(mesh), Look::Scan, no_views), InvalidInput);
  FigureOptions coarse = options;
  coarse.max_elements = 10;
  EXPECT_THROW(draw(bare(mesh), Look::Scan, coarse), InvalidInput);
  FigureOptions denser = options;
  denser.pixel_ratio = 5;
  EXPECT_THROW(draw(bare(mesh), Look::Scan, denser), InvalidInput);
  FigureOptions upside_down = options;
  upside_down.scale.high = -1.0;
  EXPECT_THROW(draw(bare(mesh), Look::Scan, upside_down), InvalidInput);
}

}  // namespace
}  // namespace regarment
