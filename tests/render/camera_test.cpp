#include "render/camera.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace regarment {
namespace {

const Box kPerson = {{-0.5, 0.0, -0.2}, {0.5, 1.7, 0.2}};

Camera camera_of(View view) { return frame_views(kPerson, std::vector<View>{view}).front(); }

TEST(Camera, ShowsTheMiddleOfTheBoxInTheMiddleOfThePicture) {
  for (const Camera& camera : frame_views(kPerson, four_sides())) {
    const Vec3 pixel = camera.pixel_from_body({0.0, 0.85, 0.0});
    EXPECT_NEAR(pixel.x(), 260.0, 1e-9);
    EXPECT_NEAR(pixel.y(), 450.0, 1e-9);
    EXPECT_NEAR(pixel.z(), 0.0, 1e-12);
  }
}

// Seen from the front the person's left hand (+x) is on the right of the picture, the face (+z) is
// near. Each side is a quarter turn on.
TEST(Camera, PlacesLeftFrontAndUpOnEverySide) {
  struct Case {
    View view;
    Vec3 right, near;  // body directions
  };
  const std::vector<Case> cases = {{View::Front, {1, 0, 0}, {0, 0, 1}},
                                   {View::Left, {0, 0, -1}, {1, 0, 0}},
                                   {View::Back, {-1, 0, 0}, {0, 0, -1}},
                                   {View::Right, {0, 0, 1}, {-1, 0, 0}}};
  for (const Case& c : cases) {
    const Camera camera = camera_of(c.view);
    const double scale = camera.pixels_per_metre;
    const Vec3 middle = camera.pixel_from_body(camera.centre);
    const auto moved = [&](const Vec3& by) -> Vec3 {
      return camera.pixel_from_body(camera.centre + by) - middle;
    };
    EXPECT_TRUE(moved(c.right).isApprox(Vec3(scale, 0, 0), 1e-12)) << view_name(c.view);
    EXPECT_TRUE(moved(c.near).isApprox(Vec3(0, 0, -1), 1e-12)) << view_name(c.view);
    EXPECT_TRUE(moved({0, 1, 0}).isApprox(Vec3(0, -scale, 0), 1e-12)) << view_name(c.view);
  }
}

TEST(Camera, FrontLeftStandsBetweenFrontAndLeft) {
  const Camera camera = camera_of(View::FrontLeft);
  const Vec3 towards = camera.view_from_body.row(2);
  EXPECT_TRUE(towards.isApprox(Vec3(1, 0, 1).normalized(), 1e-12));
}

TEST(Camera, EveryViewIsARotation) {
  for (int v = 0; v < 8; ++v) {
    const Eigen::Matrix3d r = camera_of(View(v)).view_from_body;
    EXPECT_TRUE((r * r.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-12));
    EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
  }
}

TEST(Camera, ComesBackFromPixelsToTheBody) {
  const Camera camera = camera_of(View::BackRight);
  const Vec3 point(0.1, 1.2, -0.15);
  EXPECT_TRUE(camera.body_from_pixel(camera.pixel_from_body(point)).isApprox(point, 1e-12));
}

TEST(Camera, FitsTheBoxWithItsMarginAtOneScale) {
  Framing framing;
  framing.margin = 0.05;
  const std::vector<Camera> cameras = frame_views(kPerson, four_sides(), framing);
  const double margin = 0.05 * 520;
  double nearest = 1e9;
  for (const Camera& camera : cameras) {
    EXPECT_EQ(camera.pixels_per_metre, cameras.front().pixels_per_metre);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 point((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 1.7 : 0.0,
                       (corner & 4) != 0 ? 0.2 : -0.2);
      const Vec3 pixel = camera.pixel_from_body(point);
      nearest = std::min({nearest, pixel.x(), pixel.y(), 520 - pixel.x(), 900 - pixel.y()});
      EXPECT_LT(std::abs(pixel.z()), camera.depth_range);
    }
  }
  EXPECT_NEAR(nearest, margin, 1e-9);  // the largest scale that leaves the margin
}

TEST(Camera, RefusesWhatCannotBeFramed) {
  EXPECT_THROW(frame_views(Box(), four_sides()), InvalidInput);
  EXPECT_THROW(frame_views({{1, 1, 1}, {1, 1, 1}}, four_sides()), InvalidInput);
  Framing narrow;
  narrow.width = 0;
  EXPECT_THROW(frame_views(kPerson, four_sides(), narrow), InvalidInput);
  Framing wide_margin;
  wide_margin.margin = 0.5;
  EXPECT_THROW(frame_views(kPerson, four_sides(), wide_margin), InvalidInput);
}

TEST(Camera, FramesABoxThatIsFlatFromTheSide) {
  const auto cameras = frame_views({{-1, 0, 0}, {1, 0, 0}}, std::vector<View>{View::Left});
  EXPECT_TRUE(std::isfinite(cameras.front().pixels_per_metre));
}

TEST(BoundingBox, NamesTheVertexThatIsNotFinite) {
  const std::vector<Vec3> points = {{0, 0, 0}, {0, std::nan(""), 0}};
  try {
    bounding_box(points);
    FAIL() << "no error";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 1"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace regarment
