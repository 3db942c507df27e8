#include "scan/body_frame.h"

#include <algorithm>

namespace regarment {
namespace {

constexpr double kBelow = 0.0003;  // share of the area under the floor
constexpr double kAbove = 0.0002;  // and over the head
constexpr double kEnd = 0.1;       // share of the height searched at either end

struct Piece {
  double height, area;
};

/// Area a position stands for: a third of its triangles in a mesh, the same for all in a cloud.
std::vector<double> areas_of(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  std::vector<double> areas(positions.size(), triangles.empty() ? 1.0 : 0.0);
  for (const auto& [a, b, c] : triangles) {
    const double area = (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm() / 6;
    for (const std::uint32_t v : {a, b, c}) areas[v] += area;
  }
  return areas;
}

/// Height of the piece with which more than `wanted` of area has gone by; pieces in order.
double height_after(const std::vector<Piece>& pieces, double wanted) {
  double gone = 0;
  for (const Piece& piece : pieces) {
    gone += piece.area;
    if (gone > wanted) return piece.height;
  }
  return pieces.empty() ? 0.0 : pieces.back().height;
}

}  // namespace

Eigen::Affine3d BodyFrame::to_file() const {
  Eigen::Affine3d file_from_body;
  file_from_body.linear() = turn.transpose() / metres;
  file_from_body.translation() = origin;
  return file_from_body;
}

UprightView::UprightView(const UpAxis& up) : low_(up.slices.low), height_(up.slices.height) {
  turn_.row(0) = up.direction.unitOrthogonal();
  turn_.row(1) = up.direction;
  turn_.row(2) = turn_.row(0).cross(turn_.row(1));
}

std::vector<Vec3> UprightView::from_file(std::span<const Vec3> points) const {
  std::vector<Vec3> upright(points.begin(), points.end());
  for (Vec3& p : upright) p = ((turn_ * p - low_ * Vec3::UnitY()) / height_).eval();
  return upright;
}

Reach find_reach(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                 std::span<const std::uint8_t> stray) {
  const std::vector<double> areas = areas_of(positions, triangles);
  double total = 0, low = 1e300, high = -1e300;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (stray[i] != 0) continue;
    total += areas[i];
    low = std::min(low, positions[i].y());
    high = std::max(high, positions[i].y());
  }
  std::vector<Piece> feet, head;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (stray[i] != 0) continue;
    const double height = positions[i].y();
    if (height <= low + kEnd * (high - low)) feet.push_back({height, areas[i]});
    if (height >= high - kEnd * (high - low)) head.push_back({height, areas[i]});
  }
  std::sort(feet.begin(), feet.end(), [](auto& a, auto& b) { return a.height < b.height; });
  std::sort(head.begin(), head.end(), [](auto& a, auto& b) { return a.height > b.height; });
  return {height_after(feet, kBelow * total), height_after(head, kAbove * total)};
}

}  // namespace regarment
