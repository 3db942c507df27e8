#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace regarment {

/// Where the camera stands, level, looking at the person. `Left` shows the person's left side: the
/// camera stands at +x. The three-quarter views stand between their two neighbours.
enum class View { Front, Left, Back, Right, FrontLeft, BackLeft, BackRight, FrontRight };

/// "front", "left", "back", "right", "front-left", ...
std::string_view view_name(View view);

/// The four sides in the order a person turns: front, left, back, right.
const std::vector<View>& four_sides();

/// An axis-aligned box in the body frame, metres.
struct Box {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  bool empty() const { return !(low.x() <= high.x()); }
  void add(const Vec3& point) { low = low.cwiseMin(point), high = high.cwiseMax(point); }
};

/// Throws InvalidInput naming vertex `index` when the point is not finite or further than 1e9 m
/// away.
void check_drawable(const Vec3& point, std::size_t index);

/// The box around points. Throws InvalidInput for a point that `check_drawable` refuses.
Box bounding_box(std::span<const Vec3> points);

/// Orthographic camera: body frame (metres, y up, +z to the person's front, +x to the person's
/// left) to a picture of width x height pixels, x to the right, y down, pixel (i, j) covering
/// [i, i+1) x [j, j+1). Depth is in metres, growing away from the viewer, 0 at the box's centre.
struct Camera {
  int width = 0, height = 0;
  Eigen::Matrix3d view_from_body = Eigen::Matrix3d::Identity();  // rows: right, up, towards viewer
  Vec3 centre = Vec3::Zero();  // body point shown at the middle of the picture
  double pixels_per_metre = 1.0;
  double depth_range = 1.0;  // m, everything framed has |depth| < depth_range

  /// (x pixels, y pixels, depth m).
  Vec3 pixel_from_body(const Vec3& point) const;
  /// Inverse of `pixel_from_body`.
  Vec3 body_from_pixel(const Vec3& pixel) const;
};

/// How a picture is cut.
struct Framing {
  int width = 520, height = 900;  // pixels
  double margin = 0.03;           // share of the smaller picture side left free on each edge
};

/// One camera per view around the same box, all at the same scale, so that pictures of different
/// views can be compared and pictures of different looks match pixel for pixel. The scale is the
/// largest at which the box fits in every view. Deterministic. Throws InvalidInput when the box is
/// empty, infinite or a single point, or the frame has no room.
std::vector<Camera> frame_views(const Box& box, std::span<const View> views,
                                const Framing& framing = {});

}  // namespace regarment
