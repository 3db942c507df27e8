#include "scan/mirror_plane.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "geometry/parallel.h"
#include "geometry/point_tree.h"
#include "scan/robust.h"

namespace regarment {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWorst = 0.04;       // body heights: mirrored points farther off count as this
constexpr std::size_t kFewest = 20;   // matches a plane is fitted to
constexpr std::size_t kCoarse = 500;  // points used to choose among the starts
constexpr std::size_t kFine = 2500;   // points used to refine
constexpr std::size_t kStarts = 8;    // directions tried, evenly over half a turn
constexpr double kTrunkHalf = 0.14;   // body heights from the plane: trunk, head, legs; no arms
constexpr double kAboveFeet = 0.05;

Vec2 horizontal(const Vec3& p) { return {p.x(), p.z()}; }

Vec3 mirrored(const Vec3& p, const MirrorPlane& plane) {
  const double twice = 2 * (plane.normal.dot(horizontal(p)) - plane.offset);
  return {p.x() - twice * plane.normal.x(), p.y(), p.z() - twice * plane.normal.y()};
}

std::vector<Vec3> thinned(std::span<const Vec3> points, std::size_t count) {
  std::vector<Vec3> chosen;
  const std::size_t step = std::max<std::size_t>(1, points.size() / count);
  for (std::size_t i = step / 2; i < points.size(); i += step) chosen.push_back(points[i]);
  return chosen;
}

using Part = std::function<bool(const Vec3&, const MirrorPlane&)>;

/// One mirroring: matches each point's mirror image with the nearest point of the body, then takes
/// the plane that maps the points on their matches best. False when too few match.
bool improve(const PointTree& body, std::span<const Vec3> all, std::span<const Vec3> points,
             double reach, const Part& part, MirrorPlane& plane) {
  Vec2 mean_from = Vec2::Zero(), mean_to = Vec2::Zero();
  std::vector<std::pair<Vec2, Vec2>> matches;
  double mismatch = 0, counted = 0;
  for (const Vec3& p : points) {
    if (!part(p, plane)) continue;
    PointNeighbour hit;
    const bool found = body.nearest(mirrored(p, plane), {&hit, 1}, std::max(reach, kWorst)) == 1;
    const double distance = found ? std::sqrt(hit.squared_distance) : kWorst;
    mismatch += std::min(distance, kWorst);
    counted += 1;
    if (distance >= reach || !found) continue;
    matches.emplace_back(horizontal(p), horizontal(all[hit.index]));
    mean_from += matches.back().first;
    mean_to += matches.back().second;
  }
  if (matches.size() < kFewest) return false;
  plane.mismatch = mismatch / counted;
  mean_from /= static_cast<double>(matches.size());
  mean_to /= static_cast<double>(matches.size());
  Eigen::Matrix2d cross = Eigen::Matrix2d::Zero();
  for (const auto& [from, to] : matches) {
    cross += (from - mean_from) * (to - mean_to).transpose();
  }
  // Mirroring turns the part along n round, so n has the least of from . to.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(cross + cross.transpose());
  const Vec2 normal = solver.eigenvectors().col(0);
  plane.normal = normal.dot(plane.normal) < 0 ? Vec2(-normal) : normal;
  plane.offset = plane.normal.dot(mean_from + mean_to) / 2;
  return true;
}

bool whole(const Vec3&, const MirrorPlane&) { return true; }

bool near_the_plane(const Vec3& p, const MirrorPlane& plane) {
  return p.y() > kAboveFeet &&
         std::abs(plane.normal.dot(horizontal(p)) - plane.offset) < kTrunkHalf;
}

/// Direction of the longer horizontal axis of the trunk: hips and shoulders.
double trunk_angle(std::span<const Vec3> upright) {
  Vec2 mean = Vec2::Zero();
  double count = 0;
  for (const Vec3& p : upright) {
    if (p.y() < 0.5 || p.y() > 0.8) continue;
    mean += horizontal(p);
    count += 1;
  }
  mean /= std::max(count, 1.0);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec3& p : upright) {
    if (p.y() < 0.5 || p.y() > 0.8) continue;
    spread += (horizontal(p) - mean) * (horizontal(p) - mean).transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(spread);
  const Vec2 axis = solver.eigenvectors().col(1);
  return std::atan2(axis.y(), axis.x());
}

MirrorPlane best_start(const PointTree& body, std::span<const Vec3> upright) {
  const double first = trunk_angle(upright);
  const std::vector<Vec3> coarse = thinned(upright, kCoarse);
  std::array<MirrorPlane, kStarts> tried;
  parallel_for(kStarts, 1, [&](std::size_t begin, std::size_t) {
    MirrorPlane plane;
    const double angle = first + kPi * static_cast<double>(begin) / kStarts;
    plane.normal = {std::cos(angle), std::sin(angle)};
    plane.offset =
        quantile_of(coarse, 0.5, [&](const Vec3& p) { return plane.normal.dot(horizontal(p)); });
    plane.mismatch = kWorst;
    for (int pass = 0; pass < 12; ++pass) {
      const double reach = std::max(0.02, 0.05 * (1 - pass / 8.0));
      if (!improve(body, upright, coarse, reach, whole, plane)) {
        plane.mismatch = kWorst;
        break;
      }
    }
    tried[begin] = plane;
  });
  return *std::min_element(tried.begin(), tried.end(),
                           [](const auto& a, const auto& b) { return a.mismatch < b.mismatch; });
}

}  // namespace

MirrorPlane find_mirror_plane(std::span<const Vec3> upright) {
  MirrorPlane plane;
  plane.mismatch = kWorst;
  if (upright.size() < kFewest) return plane;
  const PointTree body(upright);
  plane = best_start(body, upright);
  const std::vector<Vec3> fine = thinned(upright, kFine);
  for (int pass = 0; pass < 4; ++pass) improve(body, upright, fine, 0.02, whole, plane);
  const MirrorPlane of_all = plane;
  for (int pass = 0; pass < 8; ++pass) {
    if (!improve(body, upright, fine, 0.015, near_the_plane, plane)) return of_all;
  }
  return plane;
}

}  // namespace regarment
