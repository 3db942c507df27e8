#include "bench/step_system.h"

#include <cmath>

namespace regarment {
namespace {

std::vector<std::array<int, 2>> pairs_of(const JointModel& model) {
  std::vector<std::array<int, 2>> out;
  for (const Spring& s : model.springs()) out.push_back({s.particle_a, s.particle_b});
  return out;
}

/// The garment rolled round a trunk, so that springs and normals point in all directions.
std::vector<Vec3> rolled(const Pattern& pattern) {
  std::vector<Vec3> x(pattern.particle_count);
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    const double phi = pattern.flat[v].x() / 0.16;
    const double side = pattern.panel_is_front[pattern.panel[v]] ? 1 : -1;
    x[pattern.particle[v]] = {0.16 * std::sin(phi), -pattern.flat[v].y(),
                              side * 0.16 * std::cos(phi)};
  }
  return x;
}

}  // namespace

StepSystem step_system(const JointModel& model) {
  const int n = model.pattern().particle_count;
  const Eigen::Index rows = 3 * static_cast<Eigen::Index>(n);
  StepSystem out{BlockTriangle(n, pairs_of(model)), {}, {}};
  const std::vector<Vec3> x = rolled(model.pattern());
  std::vector<Eigen::Triplet<double>> all;
  const auto add = [&](int i, int j, const Eigen::Matrix3d& block) {
    out.blocks.add(i, j, block);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) all.emplace_back(3 * i + r, 3 * j + c, block(r, c));
  };
  for (std::size_t s = 0; s < model.springs().size(); ++s) {
    const auto [a, b] = std::pair(model.springs()[s].particle_a, model.springs()[s].particle_b);
    const Vec3 along = (x[b] - x[a]).normalized();
    const Eigen::Matrix3d block = model.spring_weight(s) * along * along.transpose();
    add(a, a, block), add(b, b, block), add(a, b, -block), add(b, a, -block);
  }
  for (int i = 0; i < n; ++i) {
    const Vec3 normal = Vec3(x[i].x(), 0, x[i].z()).normalized();
    const double share = model.particle_areas()[i] / model.scales().patch;
    add(i, i,
        share *
            (kStepAcross * normal * normal.transpose() + kStepPull * Eigen::Matrix3d::Identity()));
  }
  out.matrix.resize(rows, rows);
  out.matrix.setFromTriplets(all.begin(), all.end());
  out.right.resize(rows, static_cast<Eigen::Index>(model.dimension_count()) + 1);
  for (Eigen::Index c = 0; c < out.right.cols(); ++c)
    for (Eigen::Index i = 0; i < out.right.rows(); ++i)
      out.right(i, c) = std::sin(0.37 * static_cast<double>(i) * static_cast<double>(c + 1));
  return out;
}

}  // namespace regarment
