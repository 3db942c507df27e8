#include "render/geometry_pass.h"

#include <gtest/gtest.h>

#include <thread>

#include "render/flat_triangles.h"
#include "render/shapes.h"

namespace regarment {
namespace {

constexpr double kSnap = 1.0 / 64;  // pixels; OpenGL places corners to a 256th of a pixel

Camera square_camera(const Box& box, View view, int size) {
  Framing framing;
  framing.width = framing.height = size;
  return frame_views(box, std::vector<View>{view}, framing).front();
}

GeometryBuffers draw(const DisplayMesh& mesh, const Camera& camera) {
  GeometryPass pass;
  const UploadedMesh uploaded(mesh, camera.centre);
  return pass.draw(uploaded, camera);
}

GeometryBuffers draw_mesh(const Mesh& mesh, const Camera& camera) {
  return draw(make_display_mesh(mesh, {}, {}, camera.centre, 1'000'000), camera);
}

template <typename Visit>
void for_each_pixel(const GeometryBuffers& seen, Visit visit) {
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) visit(x + seen.left, y + seen.top, seen.index(x, y));
  }
}

TEST(GeometryPass, ShowsTheTriangleThatARayHitsFirst) {
  const Mesh mesh = test::random_triangles(40, 11);
  for (const View view : {View::Front, View::BackLeft}) {
    const Camera camera = square_camera(bounding_box(mesh.positions), view, 96);
    const GeometryBuffers seen = draw_mesh(mesh, camera);
    const test::FlatTriangles truth(mesh, camera);
    int checked = 0;
    for_each_pixel(seen, [&](int x, int y, std::size_t i) {
      const auto hit = truth.at({x + 0.5, y + 0.5});
      // Where two triangles cross, single precision decides.
      if (hit.to_edge < kSnap || hit.next_depth - hit.depth < 0.01) return;
      ++checked;
      EXPECT_EQ(int(seen.id[i]) - 1, hit.triangle) << x << ", " << y;
      if (hit.triangle < 0 || seen.id[i] == 0) return;
      EXPECT_NEAR(double(seen.depth[i]), hit.depth, 0.02);
    });
    EXPECT_GT(checked, 96 * 96 / 2);
  }
}

TEST(GeometryPass, MeasuresTheDepthOfATiltedPlane) {
  Mesh mesh;  // z = 0.3 x - 0.2 y, front face towards +z
  for (const Vec2& p : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
    mesh.positions.emplace_back(p.x(), p.y(), 0.3 * p.x() - 0.2 * p.y());
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Camera camera = square_camera(bounding_box(mesh.positions), View::Front, 80);
  const GeometryBuffers seen = draw_mesh(mesh, camera);
  const Vec3 normal = Vec3(-0.3, 0.2, 1.0).normalized();
  int covered = 0;
  for_each_pixel(seen, [&](int x, int y, std::size_t i) {
    if (seen.id[i] == 0) return;
    ++covered;
    const Vec3 p = camera.body_from_pixel({x + 0.5, y + 0.5, double(seen.depth[i])});
    // Corners move by up to 1/256 pixel, which is 1e-4 m here.
    EXPECT_NEAR(p.z(), 0.3 * p.x() - 0.2 * p.y(), 1e-4);
    EXPECT_NEAR(seen.normal[i][0] / 32767.0, normal.x(), 1e-4);
    EXPECT_NEAR(seen.normal[i][1] / 32767.0, normal.y(), 1e-4);
  });
  EXPECT_GT(covered, 4000);
}

TEST(GeometryPass, LightsTheInsideOfASheetLikeItsOutside) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0.5}, {1, -1, -0.5}, {1, 1, -0.5}};  // normal (0.5, 0, 1) / sqrt(1.25)
  mesh.triangles = {{0, 1, 2}};
  const Box box = bounding_box(mesh.positions);
  const GeometryBuffers back = draw_mesh(mesh, square_camera(box, View::Back, 40));
  // Turned to a viewer behind it the normal is (-0.5, 0, -1), and right in the view is -x.
  int covered = 0;
  for_each_pixel(back, [&](int, int, std::size_t i) {
    if (back.id[i] == 0) return;
    ++covered;
    EXPECT_NEAR(back.normal[i][0] / 32767.0, 0.5 / std::sqrt(1.25), 1e-4);
  });
  EXPECT_GT(covered, 300);
}

TEST(GeometryPass, SeesTheNormalsAndDepthsOfASphere) {
  constexpr double kRadius = 0.7;
  const Mesh mesh = test::sphere_mesh(kRadius, 120);
  for (const View view : four_sides()) {
    const Camera camera = square_camera(bounding_box(mesh.positions), view, 128);
    const GeometryBuffers seen = draw_mesh(mesh, camera);
    int checked = 0;
    for_each_pixel(seen, [&](int x, int y, std::size_t i) {
      const double u = (x + 0.5 - 64) / camera.pixels_per_metre;
      const double v = (64 - y - 0.5) / camera.pixels_per_metre;
      if (std::hypot(u, v) > 0.9 * kRadius) return;
      ++checked;
      ASSERT_NE(seen.id[i], 0U);
      // Chords of 1/120 of a half turn leave the sphere by 1e-4 of the radius, and twice as steep
      // at nine tenths of it.
      EXPECT_NEAR(double(seen.depth[i]), -std::sqrt(kRadius * kRadius - u * u - v * v), 4e-4);
      EXPECT_NEAR(seen.normal[i][0] / 32767.0, u / kRadius, 1e-3);
      EXPECT_NEAR(seen.normal[i][1] / 32767.0, v / kRadius, 1e-3);
    });
    EXPECT_GT(checked, 8000);
  }
}

TEST(GeometryPass, DiscsOfACloudCloseASphereAndKeepItsOutline) {
  constexpr double kRadius = 0.7;
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Mesh cloud = test::sphere_cloud(kRadius, 20'000, seed);
    const Camera camera = square_camera(bounding_box(cloud.positions), View::Left, 200);
    const DisplayMesh display = make_display_mesh(cloud, {}, {}, camera.centre, 60'000);
    const GeometryBuffers seen = draw(display, camera);
    for_each_pixel(seen, [&](int x, int y, std::size_t i) {
      const Vec2 from_middle((x + 0.5 - 100), (100 - y - 0.5));
      const double distance = from_middle.norm() / camera.pixels_per_metre;
      if (distance < kRadius - display.spacing) {
        EXPECT_NE(seen.id[i], 0U) << "hole at " << x << ", " << y;
      }
      if (distance > kRadius + 1.5 * display.spacing) {
        EXPECT_EQ(seen.id[i], 0U);
      }
      if (seen.id[i] == 0 || distance > 0.9 * kRadius) return;
      const double depth = -std::sqrt(kRadius * kRadius - distance * distance);
      // A disc sinks by half its radius and leaves the sphere by its sagitta.
      EXPECT_NEAR(double(seen.depth[i]), depth, display.spacing);
      const Vec3 point = display.positions[seen.id[i] - 1].cast<double>() + camera.centre;
      const Vec3 here = camera.body_from_pixel({x + 0.5, y + 0.5, depth});
      EXPECT_LT((point - here).norm(), 1.5 * display.spacing);
      EXPECT_NEAR(seen.normal[i][0] / 32767.0, from_middle.x() / camera.pixels_per_metre / kRadius,
                  2.0 * display.spacing / kRadius);
      EXPECT_NEAR(seen.normal[i][1] / 32767.0, from_middle.y() / camera.pixels_per_metre / kRadius,
                  2.0 * display.spacing / kRadius);
    });
  }
}

TEST(GeometryPass, GivesEachPixelOfACloudToTheNearestPoint) {
  Mesh cloud;  // a grid of points 0.1 m apart, facing the viewer
  for (int j = 0; j < 12; ++j) {
    for (int i = 0; i < 12; ++i) cloud.positions.emplace_back(0.1 * i, 0.1 * j, 0.0);
  }
  DisplayMesh display;
  const Camera camera = square_camera(bounding_box(cloud.positions), View::Front, 240);
  for (const Vec3& p : cloud.positions) {
    display.positions.push_back((p - camera.centre).cast<float>());
    display.normals.emplace_back(0.0F, 0.0F, 1.0F);
  }
  display.spacing = 0.1;
  const GeometryBuffers seen = draw(display, camera);
  int checked = 0;
  for_each_pixel(seen, [&](int x, int y, std::size_t i) {
    const Vec3 here = camera.body_from_pixel({x + 0.5, y + 0.5, 0.0});
    const double u = here.x() / 0.1, v = here.y() / 0.1;
    const int column = int(std::lround(u)), row = int(std::lround(v));
    const bool inside = column >= 0 && column < 12 && row >= 0 && row < 12;
    // Half a pixel from the middle between two points either may win.
    const double clear = 0.5 - std::max(std::abs(u - column), std::abs(v - row));
    if (!inside || clear * 0.1 * camera.pixels_per_metre < 0.5) return;
    ++checked;
    EXPECT_EQ(seen.id[i], std::uint32_t(1 + 12 * row + column)) << x << ", " << y;
  });
  EXPECT_GT(checked, 20'000);
}

TEST(GeometryPass, CutsOffWhatLiesOutsideThePicture) {
  const Mesh mesh = test::sphere_mesh(1.0, 20);
  const Camera camera = square_camera({{-0.2, -0.2, -2}, {0.2, 0.2, 2}}, View::Front, 50);
  const GeometryBuffers seen = draw_mesh(mesh, camera);
  EXPECT_EQ(seen.width, 50);
  EXPECT_EQ(seen.height, 50);
  Camera away = camera;
  away.centre.x() += 10.0;
  EXPECT_TRUE(draw_mesh(mesh, away).id.empty());
}

TEST(GeometryPass, DrawsTheSameBytesAgainAndInAnotherThread) {
  const Mesh mesh = test::mannequin();
  Mesh cloud = mesh;
  cloud.triangles.clear();
  for (const Mesh& shape : {mesh, cloud}) {
    const Camera camera = square_camera(bounding_box(mesh.positions), View::FrontRight, 160);
    const GeometryBuffers first = draw_mesh(shape, camera);
    std::vector<GeometryBuffers> others(3);
    others[0] = draw_mesh(shape, camera);
    std::thread one([&] { others[1] = draw_mesh(shape, camera); });
    std::thread two([&] { others[2] = draw_mesh(shape, camera); });
    one.join();
    two.join();
    for (const GeometryBuffers& other : others) {
      EXPECT_EQ(first.id, other.id);
      EXPECT_EQ(first.depth, other.depth);
      EXPECT_EQ(first.normal, other.normal);
    }
  }
}

}  // namespace
}  // namespace regarment
