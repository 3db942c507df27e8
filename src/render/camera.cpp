#include "render/camera.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.h"

namespace regarment {
namespace {

struct ViewFact {
  View view;
  std::string_view name;
  int eighth_turns;  // from the front towards the person's left
};

constexpr std::array<ViewFact, 8> kViews = {{{View::Front, "front", 0},
                                             {View::FrontLeft, "front-left", 1},
                                             {View::Left, "left", 2},
                                             {View::BackLeft, "back-left", 3},
                                             {View::Back, "back", 4},
                                             {View::BackRight, "back-right", 5},
                                             {View::Right, "right", 6},
                                             {View::FrontRight, "front-right", 7}}};

const ViewFact& fact_of(View view) {
  for (const ViewFact& fact : kViews) {
    if (fact.view == view) return fact;
  }
  throw InvalidInput("unknown view " + std::to_string(int(view)));
}

// Exact for quarter turns, so that opposite views are mirror images to the last bit.
Eigen::Vector2d direction(int eighth_turns) {
  constexpr double kHalf = std::numbers::sqrt2 / 2.0;
  constexpr std::array<double, 8> kSines = {0, kHalf, 1, kHalf, 0, -kHalf, -1, -kHalf};
  return {kSines[std::size_t(eighth_turns % 8)], kSines[std::size_t((eighth_turns + 2) % 8)]};
}

Eigen::Matrix3d rotation(View view) {
  const Eigen::Vector2d towards = direction(fact_of(view).eighth_turns);  // sine, cosine
  Eigen::Matrix3d view_from_body;
  view_from_body.row(0) = Vec3(towards.y(), 0, -towards.x());  // right
  view_from_body.row(1) = Vec3(0, 1, 0);                       // up
  view_from_body.row(2) = Vec3(towards.x(), 0, towards.y());   // towards the viewer
  return view_from_body;
}

void check_frame(const Box& box, const Framing& framing) {
  if (box.empty() || !box.low.allFinite() || !box.high.allFinite()) {
    throw InvalidInput("nothing to frame: the box is empty or not finite");
  }
  if (!((box.high - box.low).maxCoeff() > 0.0)) {
    throw InvalidInput("nothing to frame: the box is a single point");
  }
  if (framing.width < 1 || framing.height < 1 || framing.width > 8192 || framing.height > 8192) {
    throw InvalidInput("framing of " + std::to_string(framing.width) + " x " +
                       std::to_string(framing.height) + " pixels, each side must be 1..8192");
  }
  if (!(framing.margin >= 0.0 && framing.margin < 0.5)) {
    throw InvalidInput("framing.margin is " + std::to_string(framing.margin) + ", must be 0..0.5");
  }
}

}  // namespace

std::string_view view_name(View view) { return fact_of(view).name; }

const std::vector<View>& four_sides() {
  static const std::vector<View> sides = {View::Front, View::Left, View::Back, View::Right};
  return sides;
}

void check_drawable(const Vec3& point, std::size_t index) {
  if (point.cwiseAbs().maxCoeff() <= 1e9 && point.allFinite()) return;
  throw InvalidInput("vertex " + std::to_string(index) + " is not finite or too far away to draw");
}

Box bounding_box(std::span<const Vec3> points) {
  Box box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    check_drawable(points[i], i);
    box.add(points[i]);
  }
  return box;
}

Vec3 Camera::pixel_from_body(const Vec3& point) const {
  const Vec3 view = view_from_body * (point - centre);
  return {0.5 * width + pixels_per_metre * view.x(), 0.5 * height - pixels_per_metre * view.y(),
          -view.z()};
}

Vec3 Camera::body_from_pixel(const Vec3& pixel) const {
  const Vec3 view((pixel.x() - 0.5 * width) / pixels_per_metre,
                  (0.5 * height - pixel.y()) / pixels_per_metre, -pixel.z());
  return view_from_body.transpose() * view + centre;
}

std::vector<Camera> frame_views(const Box& box, std::span<const View> views,
                                const Framing& framing) {
  check_frame(box, framing);
  const Vec3 half = 0.5 * (box.high - box.low);
  const double margin = framing.margin * std::min(framing.width, framing.height);
  double scale = std::numeric_limits<double>::infinity();
  std::vector<Camera> cameras;
  for (const View view : views) {
    Camera camera;
    camera.width = framing.width;
    camera.height = framing.height;
    camera.view_from_body = rotation(view);
    camera.centre = box.low + half;
    // Half-extents of the turned box along the picture's axes; a line seen from its end has some.
    const Vec3 extent =
        (camera.view_from_body.cwiseAbs() * half).cwiseMax(Vec3::Constant(1e-3 * half.norm()));
    camera.depth_range = 1.05 * half.norm();
    scale = std::min({scale, (0.5 * framing.width - margin) / extent.x(),
                      (0.5 * framing.height - margin) / extent.y()});
    cameras.push_back(camera);
  }
  for (Camera& camera : cameras) camera.pixels_per_metre = scale;
  return cameras;
}

}  // namespace regarment
