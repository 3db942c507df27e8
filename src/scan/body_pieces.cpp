#include "scan/body_pieces.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "scan/robust.h"

namespace regarment {
namespace {

constexpr double kSmallPiece = 0.02;    // of the largest piece's points; smaller are no limb
constexpr std::size_t kFew = 16;        // samples; fewer are stray points
constexpr double kFar = 0.12;           // of the longest side: no limb is this far from the rest
constexpr double kColumnLength = 0.25;  // of the longest side: shorter ones are no posts
constexpr double kSlim = 0.2;           // width over length of a post
constexpr std::size_t kLookAt = 2000;   // points of a piece compared with others

/// A piece's middle and directions: along its longest extent, and how long and wide it is.
struct Shape {
  Vec3 middle = Vec3::Zero(), along = Vec3::UnitY();
  double length = 0, width = 0;
};

std::vector<Vec3> some_of(const std::vector<Vec3>& points) {
  const std::size_t step = points.size() / kLookAt + 1;
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

double range_along(const std::vector<Vec3>& points, const Vec3& direction) {
  const auto along = [&](const Vec3& p) { return direction.dot(p); };
  return quantile_of(points, 0.98, along) - quantile_of(points, 0.02, along);
}

Shape shape_of(const std::vector<Vec3>& points) {
  Shape shape;
  for (const Vec3& p : points) shape.middle += p;
  shape.middle /= static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) {
    spread += (p - shape.middle) * (p - shape.middle).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  shape.along = solver.eigenvectors().col(2);
  shape.length = range_along(points, shape.along);
  shape.width = range_along(points, solver.eigenvectors().col(1));
  return shape;
}

/// Whether the line along a piece meets the body, as that of an arm does at the shoulder.
bool points_at(const Shape& piece, const std::vector<Vec3>& body, double reach) {
  return std::any_of(body.begin(), body.end(), [&](const Vec3& p) {
    return (p - piece.middle).cross(piece.along).squaredNorm() < reach * reach;
  });
}

double gap_between(const std::vector<Vec3>& piece, const std::vector<Vec3>& body) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& p : piece) {
    for (const Vec3& q : body) nearest = std::min(nearest, (p - q).squaredNorm());
  }
  return std::sqrt(nearest);
}

Belongs judge(const SamplePiece& all, const std::vector<Vec3>& body, bool small, double cell,
              double longest) {
  if (all.samples < kFew) return Belongs::Stray;
  const std::vector<Vec3> piece = some_of(all.points);
  const Shape shape = shape_of(piece);
  const bool column = shape.length > kColumnLength * longest && shape.width < kSlim * shape.length;
  if (column && !points_at(shape, body, shape.width / 2 + 2 * cell)) return Belongs::Post;
  if (small || gap_between(piece, body) > kFar * longest) return Belongs::Island;
  return Belongs::Body;
}

}  // namespace

std::vector<Belongs> judge_pieces(std::span<const SamplePiece> pieces, double cell,
                                  double longest) {
  std::vector<Belongs> belongs(pieces.size(), Belongs::Body);
  if (pieces.empty()) return belongs;
  const auto largest = std::max_element(
      pieces.begin(), pieces.end(),
      [](const SamplePiece& a, const SamplePiece& b) { return a.points.size() < b.points.size(); });
  const std::vector<Vec3> body = some_of(largest->points);
  const double least = kSmallPiece * static_cast<double>(largest->points.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (&pieces[i] == &*largest) continue;
    const bool small = static_cast<double>(pieces[i].points.size()) < least;
    belongs[i] = judge(pieces[i], body, small, cell, longest);
  }
  return belongs;
}

}  // namespace regarment
