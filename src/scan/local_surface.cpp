#include "scan/local_surface.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/parallel.h"
#include "scan/robust.h"

namespace regarment {
namespace {

constexpr std::size_t kMostNeighbours = 64;
constexpr std::size_t kGapNeighbours = 6;
constexpr std::size_t kFirstFit = 20;     // neighbours of the first quadric
constexpr std::size_t kLargestFit = 320;  // and of the last, each four times the one before
constexpr double kLargestPatch = 0.015;   // m; beyond, shape would be taken for noise
constexpr double kFlatEnough =
    0.25;  // noise over patch radius above which a larger patch is needed
constexpr int kUnknowns = 6;

struct Spread {
  Vec3 mean = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns, narrowest first
};

Spread spread_of(std::span<const Vec3> points, std::span<const PointNeighbour> chosen) {
  Spread spread;
  for (const PointNeighbour& n : chosen) spread.mean += points[n.index];
  spread.mean /= static_cast<double>(chosen.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const PointNeighbour& n : chosen) {
    const Vec3 d = points[n.index] - spread.mean;
    covariance.noalias() += d * d.transpose();
  }
  // Scaled, because the closed form loses its digits on very small numbers.
  const double trace = covariance.trace();
  if (!(trace > 0)) return spread;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance / trace);
  if (solver.eigenvectors().allFinite()) spread.axes = solver.eigenvectors();
  return spread;
}

/// Variance about the quadric z(x, y) over the plane of the points, and their mean radius in it.
struct Residual {
  double variance = 0.0, radius = 0.0;
};

std::optional<Residual> quadric_residual(std::span<const Vec3> points,
                                         std::span<const PointNeighbour> chosen) {
  using Row = Eigen::Matrix<double, kUnknowns, 1>;
  if (chosen.size() < 2 * kUnknowns) return std::nullopt;
  const Spread spread = spread_of(points, chosen);
  const double scale = std::sqrt(chosen.back().squared_distance);
  if (!(scale > 0)) return std::nullopt;
  Eigen::Matrix<double, kUnknowns, kUnknowns> normal_matrix;
  normal_matrix.setZero();
  Row right = Row::Zero();
  double squares = 0, radius = 0;
  for (const PointNeighbour& n : chosen) {
    const Vec3 local = spread.axes.transpose() * (points[n.index] - spread.mean) / scale;
    const double x = local[1], y = local[2], z = local[0];
    const Row row = (Row() << 1, x, y, x * x, x * y, y * y).finished();
    normal_matrix.noalias() += row * row.transpose();
    right += z * row;
    squares += z * z;
    radius += std::hypot(x, y);
  }
  const Row solution = normal_matrix.ldlt().solve(right);
  const double rest = std::max(0.0, squares - solution.dot(right));
  const auto count = static_cast<double>(chosen.size());
  if (!std::isfinite(rest)) return std::nullopt;
  return Residual{rest / (count - kUnknowns) * scale * scale, radius / count * scale};
}

Residual median_residual(std::span<const Vec3> points, const PointTree& tree,
                         std::span<const std::uint32_t> places, std::size_t neighbours) {
  std::vector<double> variances(places.size(), -1.0), radii(places.size(), -1.0);
  parallel_for(places.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<PointNeighbour> found(neighbours);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t count = tree.nearest(points[places[i]], found);
      const auto residual = quadric_residual(points, std::span(found).first(count));
      if (!residual) continue;
      variances[i] = residual->variance;
      radii[i] = residual->radius;
    }
  });
  std::erase(variances, -1.0);
  std::erase(radii, -1.0);
  return {quantile(std::move(variances), 0.5), quantile(std::move(radii), 0.5)};
}

}  // namespace

LocalSurface local_surface(std::span<const Vec3> points, const PointTree& tree,
                           std::size_t neighbours) {
  neighbours = std::min(neighbours, kMostNeighbours);
  LocalSurface surface;
  surface.normals.resize(points.size());
  surface.gap.resize(points.size());
  surface.nearest.resize(points.size());
  const std::span<const std::uint32_t> order = tree.order();
  parallel_for(points.size(), 2048, [&](std::size_t begin, std::size_t end) {
    std::array<PointNeighbour, kMostNeighbours> buffer;
    for (std::size_t at = begin; at < end; ++at) {
      const std::uint32_t i = order[at];
      const std::span<PointNeighbour> all(buffer.data(), neighbours);
      const auto found = all.first(tree.nearest(points[i], all));
      surface.normals[i] =
          found.size() < 3 ? Vec3(Vec3::UnitY()) : Vec3(spread_of(points, found).axes.col(0));
      double sum = 0;
      const std::size_t others = std::min(found.size(), kGapNeighbours + 1);  // the first is itself
      for (std::size_t n = 1; n < others; ++n) sum += std::sqrt(found[n].squared_distance);
      const double gap = others > 1 ? sum / static_cast<double>(others - 1) : 0.0;
      surface.gap[i] = static_cast<float>(gap);
      for (std::size_t n = 0; n < LocalSurface::kKept; ++n) {
        surface.nearest[i][n] = n + 1 < found.size() ? found[n + 1].index : i;
      }
    }
  });
  return surface;
}

SamplingQuality sampling_quality(std::span<const Vec3> points, const PointTree& tree,
                                 std::span<const std::uint32_t> places) {
  SamplingQuality quality;
  std::vector<double> spacings(places.size());
  parallel_for(places.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::array<PointNeighbour, 2> found;  // the first is the point itself
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t count = tree.nearest(points[places[i]], found);
      spacings[i] = count == 2 ? std::sqrt(found[1].squared_distance) : 0.0;
    }
  });
  quality.spacing = quantile(spacings, 0.5);
  for (std::size_t neighbours = kFirstFit; neighbours <= kLargestFit; neighbours *= 4) {
    const Residual residual = median_residual(points, tree, places, neighbours);
    quality.noise = std::sqrt(residual.variance);
    if (quality.noise < kFlatEnough * residual.radius || 2 * residual.radius > kLargestPatch) break;
  }
  return quality;
}

}  // namespace regarment
