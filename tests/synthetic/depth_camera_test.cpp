#include "synthetic/depth_camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <optional>

#include "base/error.h"
#include "base/random.h"

namespace regarment {
namespace {

struct Soup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

Soup random_triangles(int count) {
  Random random(5);
  Soup soup;
  for (int i = 0; i < count; ++i) {
    const Vec3 middle(random.uniform(-0.4, 0.4), random.uniform(0.6, 1.4),
                      random.uniform(-0.4, 0.4));
    for (int k = 0; k < 3; ++k)
      soup.positions.emplace_back(
          middle + 0.2 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    const auto first = static_cast<std::uint32_t>(3 * i);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

DepthCamera camera_for(const Soup& soup) {
  return aim_camera({0.3, 1.5, 2}, {0, 1, 0}, 0.4, 0.02, soup.positions);
}

/// Share of the way from `eye` to `beyond` at which the ray goes through a triangle; within
/// `margin` of its edges nothing is said.
struct Crossing {
  double share;
  bool sure;
};
std::optional<Crossing> cross(const Vec3& eye, const Vec3& beyond, const Vec3& a, const Vec3& b,
                              const Vec3& c) {
  Eigen::Matrix3d m;
  m << b - a, c - a, eye - beyond;
  const Vec3 x = m.fullPivLu().solve(eye - a);
  const double least = std::min({x.x(), x.y(), 1 - x.x() - x.y()});
  if (least < -1e-6) return std::nullopt;
  return Crossing{x.z(), least > 1e-6};
}

TEST(DepthCamera, PixelAndBodyAreEachOthersInverse) {
  const DepthCamera camera = camera_for(random_triangles(20));
  const Vec3 point(0.1, 1.2, -0.3);
  EXPECT_LT((camera.body_from_pixel(camera.pixel_from_body(point)) - point).norm(), 1e-12);
  EXPECT_NEAR(camera.pixel_from_body({0, 1, 0}).z(), (camera.eye - Vec3(0, 1, 0)).norm(), 1e-12);
}

TEST(DepthCamera, LooksRightAndUpright) {
  const DepthCamera camera = camera_for(random_triangles(20));
  const Vec3 middle = camera.pixel_from_body({0, 1, 0});
  EXPECT_NEAR(middle.x(), camera.axis_x, 1e-9);
  EXPECT_NEAR(middle.y(), camera.axis_y, 1e-9);
  EXPECT_LT(camera.pixel_from_body({0, 1.1, 0}).y(), middle.y());
  EXPECT_GT(camera.pixel_from_body({0.1, 1, 0}).x(), middle.x());
  // 1 cm across at the target is half a pixel of 2 cm.
  const Vec3 right = camera.view_from_body.row(0);
  EXPECT_NEAR(camera.pixel_from_body(Vec3(0, 1, 0) + 0.01 * right).x() - middle.x(), 0.5, 1e-9);
}

TEST(DepthCamera, PictureIsThatOfEveryRayByBruteForce) {
  const Soup soup = random_triangles(60);
  const DepthPicture picture = draw_depth(camera_for(soup), soup.positions, soup.triangles);
  const DepthCamera& camera = picture.camera;
  int hits = 0;
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const Vec3 beyond = camera.body_from_pixel({x + 0.5, y + 0.5, 10});
      double nearest = 1;
      std::uint32_t which = DepthPicture::kNone;
      bool sure = true;
      for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        const auto hit =
            cross(camera.eye, beyond, soup.positions[a], soup.positions[b], soup.positions[c]);
        if (!hit) continue;
        sure = sure && hit->sure;
        if (hit->share < nearest) nearest = hit->share, which = t;
      }
      if (!sure) continue;
      const std::size_t i = picture.index(x, y);
      ASSERT_EQ(picture.triangle[i], which) << x << " " << y;
      if (which == DepthPicture::kNone) {
        EXPECT_TRUE(std::isinf(picture.depth[i]));
        continue;
      }
      ++hits;
      EXPECT_NEAR(picture.depth[i], 10 * nearest, 1e-9);
    }
  EXPECT_GT(hits, 200);
}

TEST(DepthCamera, NeighboursLeaveNoGap) {
  // A wall of thin triangles around one corner covers each pixel it should.
  Soup soup;
  soup.positions.push_back({0.0013, 1.0007, 0});
  constexpr int kParts = 97;
  for (int i = 0; i < kParts; ++i) {
    const double angle = 2 * 3.14159265358979 * i / kParts;
    soup.positions.push_back({std::sin(angle), 1 + std::cos(angle), 0});
    soup.triangles.push_back({0, std::uint32_t(1 + i), std::uint32_t(1 + (i + 1) % kParts)});
  }
  const DepthCamera camera = aim_camera({0, 1, 2}, {0, 1, 0}, 0.5, 0.01, soup.positions);
  const DepthPicture picture = draw_depth(camera, soup.positions, soup.triangles);
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const Vec3 on_wall = camera.body_from_pixel({x + 0.5, y + 0.5, 2}) - Vec3(0, 1, 0);
      if (on_wall.norm() > 0.99) continue;
      ASSERT_NEAR(picture.depth[picture.index(x, y)], 2, 1e-9);
    }
}

TEST(DepthCamera, RefusesWhatItCannotSee) {
  const std::vector<Vec3> near{{0, 1, 1.9}};
  EXPECT_THROW(aim_camera({0, 1, 2}, {0, 1, 0}, 0.5, 0.01, near), InvalidInput);
  EXPECT_THROW(aim_camera({0, 3, 0}, {0, 1, 0}, 0.5, 0.01, {}), InvalidInput);
  EXPECT_THROW(aim_camera({0, 1, 2}, {0, 1, 0}, 1e6, 0.01, std::vector<Vec3>{{1, 1, 0}}),
               InvalidInput);
}

}  // namespace
}  // namespace regarment
