#include "render/silhouette.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/flat_triangles.h"
#include "render/shapes.h"

namespace regarment {
namespace {

constexpr double kSnap = 1.0 / 64;  // pixels; OpenGL places corners to a 256th of a pixel

std::vector<Camera> square_cameras(const Box& box, int size) {
  Framing framing;
  framing.width = framing.height = size;
  return frame_views(box, four_sides(), framing);
}

TEST(Silhouette, OfABoxCoversExactlyThePixelCentresInside) {
  const Mesh mesh = test::box_mesh({-0.31, 0.0, -0.17}, {0.42, 1.63, 0.23});
  const Box box = bounding_box(mesh.positions);
  const std::vector<Silhouette> masks = four_silhouettes(mesh, box);
  const std::vector<Camera> cameras = square_cameras(box, 256);
  ASSERT_EQ(masks.size(), 4U);
  for (std::size_t v = 0; v < 4; ++v) {
    const Vec3 a = cameras[v].pixel_from_body(box.low), b = cameras[v].pixel_from_body(box.high);
    for (int y = 0; y < 256; ++y) {
      for (int x = 0; x < 256; ++x) {
        const double cx = x + 0.5, cy = y + 0.5;
        const bool inside = cx > std::min(a.x(), b.x()) && cx < std::max(a.x(), b.x()) &&
                            cy > std::min(a.y(), b.y()) && cy < std::max(a.y(), b.y());
        ASSERT_EQ(masks[v].covered[std::size_t(y * 256 + x)] != 0, inside)
            << "view " << v << " pixel " << x << ", " << y;
      }
    }
  }
}

TEST(Silhouette, OfTrianglesAgreesWithEveryPixelCentreByHand) {
  const Mesh mesh = test::random_triangles(12, 7);
  const Box box = bounding_box(mesh.positions);
  const std::vector<Silhouette> masks = four_silhouettes(mesh, box, 128);
  const std::vector<Camera> cameras = square_cameras(box, 128);
  int checked = 0;
  for (std::size_t v = 0; v < 4; ++v) {
    const test::FlatTriangles truth(mesh, cameras[v]);
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {
        const auto hit = truth.at({x + 0.5, y + 0.5});
        if (hit.to_edge < kSnap) continue;
        ++checked;
        ASSERT_EQ(masks[v].covered[std::size_t(y * 128 + x)] != 0, hit.triangle >= 0)
            << "view " << v << " pixel " << x << ", " << y;
      }
    }
  }
  EXPECT_GT(checked, 4 * 128 * 128 * 9 / 10);
}

// A convex outline cannot miscount more pixels than it passes: at most 4 per pixel of diameter.
TEST(Silhouette, OfASphereHasTheAreaOfItsDisc) {
  const Mesh mesh = test::sphere_mesh(0.8, 200);
  const Box box = bounding_box(mesh.positions);
  const double radius = 0.8 * square_cameras(box, 256).front().pixels_per_metre;
  for (const Silhouette& mask : four_silhouettes(mesh, box)) {
    EXPECT_NEAR(double(mask.area()), std::numbers::pi * radius * radius, 8.0 * radius * 0.1);
  }
}

TEST(Silhouette, OppositeSidesAreMirrorImages) {
  const Mesh mesh = test::random_triangles(9, 3);
  const Box box = bounding_box(mesh.positions);
  const std::vector<Silhouette> masks = four_silhouettes(mesh, box, 96);
  const std::vector<Camera> cameras = square_cameras(box, 96);
  for (std::size_t v = 0; v < 2; ++v) {
    const test::FlatTriangles truth(mesh, cameras[v]);
    for (int y = 0; y < 96; ++y) {
      for (int x = 0; x < 96; ++x) {
        if (truth.at({x + 0.5, y + 0.5}).to_edge < kSnap) continue;
        ASSERT_EQ(masks[v].covered[std::size_t(y * 96 + x)],
                  masks[v + 2].covered[std::size_t(y * 96 + 95 - x)]);
      }
    }
  }
}

TEST(Silhouette, OfCamerasThatAreNotQuiteOppositeAreTheirOwn) {
  const Mesh mesh = test::random_triangles(9, 5);
  std::vector<Camera> cameras = square_cameras(bounding_box(mesh.positions), 96);
  Camera aside = cameras[2], nearer = cameras[2], upside_down = cameras[2];
  aside.centre.x() += 0.1;
  nearer.pixels_per_metre *= 1.2;
  upside_down.view_from_body.row(1) *= -1;
  cameras.insert(cameras.end(), {aside, nearer, upside_down});
  SilhouetteRenderer renderer(mesh.triangles, mesh.positions.size(), 96);
  const std::vector<Silhouette> masks = renderer.draw(mesh.positions, cameras);
  for (std::size_t v = 4; v < cameras.size(); ++v) {
    EXPECT_GT(masks[v].area(), 100U);
    const test::FlatTriangles truth(mesh, cameras[v]);
    for (int y = 0; y < 96; ++y) {
      for (int x = 0; x < 96; ++x) {
        const auto hit = truth.at({x + 0.5, y + 0.5});
        if (hit.to_edge < kSnap) continue;
        ASSERT_EQ(masks[v].covered[std::size_t(y * 96 + x)] != 0, hit.triangle >= 0)
            << "camera " << v << " pixel " << x << ", " << y;
      }
    }
  }
}

TEST(Silhouette, FollowsVerticesThatMoveAndForgetsWhereTheyWere) {
  const Mesh mesh = test::box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  Mesh smaller = mesh;
  for (Vec3& p : smaller.positions) p *= 0.5;
  const auto cameras = square_cameras(bounding_box(mesh.positions), 64);
  SilhouetteRenderer renderer(mesh.triangles, mesh.positions.size(), 64);
  const auto first = renderer.draw(mesh.positions, cameras);
  const auto half = renderer.draw(smaller.positions, cameras);
  const auto again = renderer.draw(mesh.positions, cameras);
  EXPECT_EQ(first.front().covered, again.front().covered);
  EXPECT_LT(half.front().area(), first.front().area() / 3);
}

TEST(Silhouette, ShowsWhatLiesFarBehindTheFramedBox) {
  Mesh mesh = test::box_mesh({-0.5, -0.5, 99.0}, {0.5, 0.5, 100.0});
  const auto cameras = square_cameras({{-1, -1, -1}, {1, 1, 1}}, 64);
  SilhouetteRenderer renderer(mesh.triangles, mesh.positions.size(), 64);
  EXPECT_GT(renderer.draw(mesh.positions, std::span(cameras).first(1)).front().area(), 500U);
}

// Corners on the centres of pixels, so that every side of the fan passes over centres.
TEST(Silhouette, TrianglesThatShareSidesCoverEachCentreOnce) {
  constexpr int kSize = 16;
  Camera camera;
  camera.width = camera.height = kSize;
  Mesh fan;
  const auto at = [](double column, double row) {
    return Vec3(column + 0.5 - 0.5 * kSize, 0.5 * kSize - row - 0.5, 0);
  };
  fan.positions = {at(8, 8),   at(2, 2),  at(8, 2),  at(14, 2), at(14, 8),
                   at(14, 14), at(8, 14), at(2, 14), at(2, 8)};
  for (std::uint32_t i = 1; i <= 8; ++i) fan.triangles.push_back({0, i, i % 8 + 1});
  std::vector<int> times(std::size_t{kSize} * kSize, 0);
  for (const Triangle& t : fan.triangles) {
    SilhouetteRenderer one(std::span(&t, 1), fan.positions.size(), kSize);
    const auto masks = one.draw(fan.positions, std::span(&camera, 1));
    for (std::size_t i = 0; i < times.size(); ++i) times[i] += masks[0].covered[i];
  }
  // Of the square's own border, left and top belong to it.
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column)
      EXPECT_EQ(times[std::size_t(row * kSize + column)],
                column >= 2 && column < 14 && row >= 2 && row < 14 ? 1 : 0)
          << column << ", " << row;
}

TEST(Silhouette, OfATriangleFarLargerThanThePictureIsCutOff) {
  Camera camera;
  camera.width = camera.height = 32;
  camera.pixels_per_metre = 10;
  // Everything above the line y = x, hundreds of pictures far.
  const std::vector<Vec3> positions = {{-900, -900, 0}, {900, 900, 0}, {-900, 900, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  SilhouetteRenderer renderer(triangles, 3, 32);
  const auto masks = renderer.draw(positions, std::span(&camera, 1));
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 32; ++column) {
      if (row == 31 - column) continue;  // on the line itself
      EXPECT_EQ(masks[0].covered[std::size_t(row * 32 + column)] != 0, row < 31 - column);
    }
}

TEST(Silhouette, RefusesWhatDoesNotFit) {
  const Mesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(SilhouetteRenderer(mesh.triangles, 7, 64), InvalidInput);
  EXPECT_THROW(SilhouetteRenderer(mesh.triangles, 8, 0), InvalidInput);
  SilhouetteRenderer renderer(mesh.triangles, 8, 64);
  const auto cameras = square_cameras(bounding_box(mesh.positions), 64);
  EXPECT_THROW(renderer.draw(std::span(mesh.positions).first(7), cameras), InvalidInput);
  const auto larger = square_cameras(bounding_box(mesh.positions), 65);
  EXPECT_THROW(renderer.draw(mesh.positions, larger), InvalidInput);
  std::vector<Vec3> broken = mesh.positions;
  broken[3].y() = std::nan("");
  EXPECT_THROW(renderer.draw(broken, cameras), InvalidInput);
}

TEST(Silhouette, OfNoTrianglesIsEmpty) {
  SilhouetteRenderer renderer({}, 0, 32);
  const auto cameras = square_cameras({{0, 0, 0}, {1, 1, 1}}, 32);
  for (const Silhouette& mask : renderer.draw({}, cameras)) EXPECT_EQ(mask.area(), 0U);
}

}  // namespace
}  // namespace regarment
