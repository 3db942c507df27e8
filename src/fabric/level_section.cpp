#include "fabric/level_section.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace regarment {
namespace {

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Half of the hull of points sorted along a line: Andrew's monotone chain.
template <typename Iterator>
double chain_length(Iterator begin, Iterator end) {
  std::vector<Vec2> chain;
  for (auto p = begin; p != end; ++p) {
    while (chain.size() > 1 && cross(chain[chain.size() - 2], chain.back(), *p) <= 0) {
      chain.pop_back();
    }
    chain.push_back(*p);
  }
  double out = 0;
  for (std::size_t k = 1; k < chain.size(); ++k) out += (chain[k] - chain[k - 1]).norm();
  return out;
}

}  // namespace

double tape_length(const std::vector<Vec3>& points) {
  if (points.size() < 3) return 0;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) scatter += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  if (axes.eigenvalues()[1] <= 1e-12 * axes.eigenvalues()[2]) return 0;
  std::vector<Vec2> seen;
  seen.reserve(points.size());
  for (const Vec3& p : points) {
    seen.emplace_back(axes.eigenvectors().col(2).dot(p - middle),
                      axes.eigenvectors().col(1).dot(p - middle));
  }
  std::sort(seen.begin(), seen.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  return chain_length(seen.begin(), seen.end()) + chain_length(seen.rbegin(), seen.rend());
}

}  // namespace regarment
