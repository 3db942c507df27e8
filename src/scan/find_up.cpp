#include "scan/find_up.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "scan/file_axis.h"
#include "scan/standing_plane.h"

namespace regarment {
namespace {

constexpr double kSureTotal = 4.0;  // likeness a free direction needs, of 7
constexpr double kFreeLead = 1.0;   // and what it must have over the best file axis
constexpr double kTilted =
    0.985;  // cosine: below, a direction is not a file axis any more (10 degrees)

std::vector<UpAxis> along_file_axes(const BodySample& sample, const std::optional<Vec3>& front) {
  std::vector<UpAxis> axes;
  for (const std::string_view name : kFileAxes) {
    const Vec3 axis = axis_vector(name);
    if (front && std::abs(axis.dot(*front)) > 0.5) continue;
    axes.push_back(look_along(sample, axis, std::string(name)));
  }
  std::stable_sort(axes.begin(), axes.end(), [](const UpAxis& a, const UpAxis& b) {
    return a.likeness.total() > b.likeness.total();
  });
  axes[0].lead = axes[0].likeness.total() - axes[1].likeness.total();
  return axes;
}

/// The principal axes of the shape, both ways round, where they are no file axes.
std::vector<UpAxis> along_principal_axes(const BodySample& sample) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : sample.points) mean += p;
  mean /= static_cast<double>(sample.points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : sample.points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  std::vector<UpAxis> axes;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = solver.eigenvectors().col(i);
    if (axis.cwiseAbs().maxCoeff() > kTilted) continue;
    for (const double sign : {1.0, -1.0}) axes.push_back(look_along(sample, sign * axis, "free"));
  }
  return axes;
}

UpAxis best_free(const BodySample& sample) {
  UpAxis best;
  for (UpAxis& axis : along_principal_axes(sample)) {
    if (axis.likeness.total() > best.likeness.total()) best = std::move(axis);
  }
  return best;
}

}  // namespace

UpAxis look_along(const BodySample& sample, const Vec3& up, std::string name) {
  UpAxis axis;
  axis.direction = up;
  axis.name = std::move(name);
  axis.slices = slice_body(sample.points, sample.cell, up);
  axis.likeness = judge_person(axis.slices);
  return axis;
}

UpAxis find_up(const BodySample& sample, const std::optional<Vec3>& front) {
  UpAxis up = std::move(along_file_axes(sample, front)[0]);
  if (front) return up;
  UpAxis free = best_free(sample);
  const double lead = free.likeness.total() - up.likeness.total();
  if (free.likeness.total() > kSureTotal && lead > kFreeLead) {
    up = std::move(free);
    up.lead = lead;
  }
  if (!up.likeness.is_person()) return up;
  if (const auto stands_on = standing_plane(sample.points, up.direction, up.slices.height)) {
    UpAxis upright = look_along(sample, *stands_on, "free");
    if (upright.likeness.total() > up.likeness.total() - 0.5) {
      upright.lead = up.lead;
      up = std::move(upright);
    }
  }
  return up;
}

}  // namespace regarment
