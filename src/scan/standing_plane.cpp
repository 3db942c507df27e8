#include "scan/standing_plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace regarment {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kReach = 35 * kPi / 180;
constexpr double kStep = 2.5 * kPi / 180;
constexpr double kBand = 0.012;         // of the height: what touches the floor
constexpr double kFootPart = 0.4;       // of the height: where feet can be, in a tilted body
constexpr std::size_t kContact = 40;    // sample points two soles, or their rims, show at least
constexpr double kFlat = 100;           // contact of a body that stands: nothing to look for
constexpr double kClearly = 2.5;        // times the contact across `up`
constexpr double kSmallestTilt = 0.05;  // rad; less is a matter of how one stands
constexpr double kBalanced = 0.08;  // of the height: how far the body's middle may be off its feet
constexpr double kBase = 0.03;      // of the height: spread of the contact across its shorter axis

/// Points no higher than `band` over the third lowest along `up`, which may be a stray one.
std::vector<Vec3> contact(const std::vector<Vec3>& points, const Vec3& up, double band) {
  std::vector<double> heights(points.size());
  std::transform(points.begin(), points.end(), heights.begin(),
                 [&](const Vec3& p) { return up.dot(p); });
  std::vector<double> sorted = heights;
  const auto third = sorted.begin() + std::min<std::ptrdiff_t>(2, std::ssize(sorted) - 1);
  std::nth_element(sorted.begin(), third, sorted.end());
  std::vector<Vec3> touching;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (heights[i] < *third + band) touching.push_back(points[i]);
  }
  return touching;
}

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// How far the middle of the body lies off the middle of what touches the floor, along the floor.
double off_balance(const Vec3& middle, const std::vector<Vec3>& touching, const Vec3& up) {
  const Vec3 over = middle - mean_of(touching);
  return (over - up.dot(over) * up).norm();
}

struct Plane {
  Vec3 normal;
  double base;  // standard deviation along the shorter axis within the plane
};

Plane fit_plane(const std::vector<Vec3>& points, const Vec3& up) {
  const Vec3 mean = mean_of(points);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vec3 normal = solver.eigenvectors().col(0);
  const double base = std::sqrt(solver.eigenvalues()[1] / static_cast<double>(points.size()));
  return {normal.dot(up) < 0 ? Vec3(-normal) : normal, base};
}

/// The direction near `up` across which most points touch the floor.
Vec3 most_contact(const std::vector<Vec3>& points, const Vec3& up, double band) {
  const Vec3 e = up.unitOrthogonal(), f = up.cross(e);
  Vec3 best = up;
  std::size_t most = contact(points, up, band).size();
  for (double tilt = kStep; tilt <= kReach; tilt += kStep) {
    const int turns = static_cast<int>(std::ceil(2 * kPi * std::sin(tilt) / kStep));
    for (int turn = 0; turn < turns; ++turn) {
      const double angle = 2 * kPi * turn / turns;
      const Vec3 side = std::cos(angle) * e + std::sin(angle) * f;
      const Vec3 direction = std::cos(tilt) * up + std::sin(tilt) * side;
      const std::size_t touching = contact(points, direction, band).size();
      if (touching > most) {
        most = touching;
        best = direction;
      }
    }
  }
  return best;
}

}  // namespace

std::optional<Vec3> standing_plane(std::span<const Vec3> points, const Vec3& up, double height) {
  double lowest = 0;
  for (const Vec3& p : points) lowest = std::min(lowest, up.dot(p - points[0]));
  std::vector<Vec3> low;
  for (const Vec3& p : points) {
    if (up.dot(p - points[0]) < lowest + kFootPart * height) low.push_back(p);
  }
  if (low.size() < kContact) return std::nullopt;
  const double band = kBand * height;
  const std::vector<Vec3> touching_now = contact(low, up, band);
  const auto as_it_is = static_cast<double>(touching_now.size());
  if (as_it_is >= kFlat) return std::nullopt;
  Vec3 normal = most_contact(low, up, band);
  for (int pass = 0; pass < 3; ++pass) {
    const std::vector<Vec3> touching = contact(low, normal, band);
    if (touching.size() < kContact || static_cast<double>(touching.size()) < kClearly * as_it_is) {
      return std::nullopt;
    }
    const Plane plane = fit_plane(touching, up);
    if (plane.base < kBase * height) return std::nullopt;
    normal = plane.normal;
  }
  // Whoever jumps may hold both soles in a plane, but does not stand over them.
  const Vec3 middle = mean_of(points);
  const double off = off_balance(middle, contact(low, normal, band), normal);
  if (off > kBalanced * height || off > off_balance(middle, touching_now, up)) return std::nullopt;
  if (std::acos(std::clamp(normal.dot(up), -1.0, 1.0)) < kSmallestTilt) return std::nullopt;
  return normal;
}

}  // namespace regarment
