#include "synthetic/file_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include <numbers>

#include "base/error.h"
#include "scan/file_axis.h"

namespace regarment {
namespace {

TEST(FileFrame, PlainFrameIsTheBodys) {
  const Vec3 p(0.1, 1.2, -0.3);
  EXPECT_LT((file_from_body({}) * p - p).norm(), 1e-15);
}

TEST(FileFrame, MillimetresWithZUp) {
  FileFrame frame;
  frame.units = "mm";
  frame.up = "+z";
  frame.shift = {0.5, 0, 2};
  const Eigen::Affine3d map = file_from_body(frame);
  // 1.5 m above the floor is 1500 along z, then the shift.
  EXPECT_LT((map * Vec3(0, 1.5, 0) - Vec3(500, 0, 3500)).norm(), 1e-9);
}

TEST(FileFrame, YawTurnsThePersonToItsLeft) {
  FileFrame frame;
  frame.yaw = std::numbers::pi / 2;
  const Eigen::Affine3d map = file_from_body(frame);
  EXPECT_LT((map * Vec3(0, 0, 1) - Vec3(1, 0, 0)).norm(), 1e-12);  // ahead is where left was
}

TEST(FileFrame, NeverMirrorsAndComesBack) {
  for (const std::string_view up : kFileAxes)
    for (const char* units : {"mm", "cm", "m", "inch"}) {
      FileFrame frame{units, std::string(up), 0.7, {100, -20, 3}};
      const Eigen::Affine3d map = file_from_body(frame);
      const double metres = 1 / std::cbrt(map.linear().determinant());
      EXPECT_GT(map.linear().determinant(), 0) << up;
      const Eigen::Matrix3d turn = metres * map.linear();
      EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
      EXPECT_LT((turn * Vec3::UnitY() - axis_vector(up)).norm(), 1e-12);
      const Vec3 p(0.3, 1.1, -0.2);
      EXPECT_LT((map.inverse() * (map * p) - p).norm(), 1e-12);
    }
}

TEST(FileFrame, MeshMovesWithItsNormals) {
  Mesh mesh;
  mesh.positions = {{0, 1, 0}};
  mesh.normals = {{0, 1, 0}};
  into_file_frame(file_from_body({"cm", "-x", 0.4, {0, 0, 0.1}}), mesh);
  EXPECT_LT((mesh.positions[0] - Vec3(-100, 0, 10)).norm(), 1e-9);
  EXPECT_LT((mesh.normals[0] - Vec3(-1, 0, 0)).norm(), 1e-12);
}

TEST(FileFrame, NamesTheAxesThePersonFaces) {
  using Names = std::vector<std::string>;
  const double quarter = std::acos(-1.0) / 2;
  EXPECT_EQ(front_axes({"m", "+y", 0, Vec3::Zero()}), Names{"+z"});
  EXPECT_EQ(front_axes({"inch", "+y", quarter, Vec3::Zero()}), Names{"+x"});
  EXPECT_EQ(front_axes({"m", "+y", quarter / 2, Vec3::Zero()}), (Names{"+x", "+z"}));
  EXPECT_EQ(front_axes({"mm", "+y", -0.6, Vec3::Zero()}), Names{"+z"});
}

TEST(FileFrame, RefusesWhatNoFileHas) {
  EXPECT_THROW(file_from_body({"ell", "+y", 0, {}}), UsageError);
  EXPECT_THROW(file_from_body({"m", "up", 0, {}}), UsageError);
  EXPECT_THROW(file_from_body({"m", "+y", std::nan(""), Vec3::Zero()}), InvalidInput);
  EXPECT_THROW(file_from_body({"m", "+y", 0, {0, 2000, 0}}), InvalidInput);
}

}  // namespace
}  // namespace regarment
