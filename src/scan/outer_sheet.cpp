#include "scan/outer_sheet.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scan/footprint.h"
#include "scan/robust.h"

namespace regarment {
namespace {

constexpr int kSteps = 12;           // directions along half an edge of a cube
constexpr double kOutside = 0.15;    // of the extent along the normal: where sheets can be
constexpr double kBand = 0.6;        // of a cell: half of what is taken for one plane
constexpr std::size_t kFewest = 80;  // sample points of a sheet
constexpr double kShare = 0.02;      // of all sample points, at least
constexpr double kBeyond = 0.05;     // of the sheet's points may lie beyond it
constexpr double kWide = 0.2;        // of the longest side: least width of a sheet
constexpr double kFree = 0.5;        // of a sheet's cells have nothing standing on them
constexpr double kOver = 0.15;       // of the longest side: how high what stands is looked at
constexpr std::size_t kDirectionsAt = 3000;  // points the directions are judged by

/// Directions to the faces of a cube, the same ones after each quarter turn.
std::vector<Vec3> all_directions() {
  std::vector<Vec3> directions;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (int u = -kSteps; u <= kSteps; ++u) {
        for (int v = -kSteps; v <= kSteps; ++v) {
          Vec3 d;
          d[axis] = sign;
          d[(axis + 1) % 3] = static_cast<double>(u) / kSteps;
          d[(axis + 2) % 3] = static_cast<double>(v) / kSteps;
          directions.push_back(d.normalized());
        }
      }
    }
  }
  return directions;
}

/// The fullest band among the outer layers along a direction.
struct Band {
  double middle = 0.0;
  std::size_t count = 0, beyond = 0;
};

Band fullest_band(std::span<const Vec3> points, const Vec3& normal, double width,
                  std::vector<double>& heights) {
  heights.resize(points.size());
  double low = 1e300, high = -1e300;
  for (std::size_t i = 0; i < points.size(); ++i) {
    heights[i] = normal.dot(points[i]);
    low = std::min(low, heights[i]);
    high = std::max(high, heights[i]);
  }
  // Bands overlap by half, so that no sheet falls between two.
  const double step = width / 2;
  const auto bins = static_cast<std::size_t>(std::ceil(kOutside * (high - low) / step)) + 2;
  std::vector<std::size_t> counts(bins, 0);
  for (const double height : heights) {
    const auto bin = static_cast<std::size_t>((height - low) / step);
    if (bin < bins) ++counts[bin];
  }
  Band best;
  std::size_t beyond = 0;
  for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
    const std::size_t count = counts[bin] + counts[bin + 1];
    if (count > best.count) {
      best = {low + (static_cast<double>(bin) + 1) * step, count, beyond};
    }
    beyond += counts[bin];
  }
  return best;
}

/// The plane through the points at most `within` of a plane, normal to the same side.
OuterSheet fit_plane(std::span<const Vec3> points, const OuterSheet& near, double within) {
  Vec3 mean = Vec3::Zero();
  double count = 0;
  for (const Vec3& p : points) {
    if (std::abs(near.above(p)) > within) continue;
    mean += p;
    count += 1;
  }
  if (count < 3) return near;
  mean /= count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) {
    if (std::abs(near.above(p)) <= within) spread += (p - mean) * (p - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  Vec3 normal = solver.eigenvectors().col(0);
  if (normal.dot(near.normal) < 0) normal = -normal;
  return {normal, normal.dot(mean), near.thickness};
}

/// Whether nothing stands on most of a sheet.
bool reaches_out(std::span<const Vec3> points, const OuterSheet& sheet, double cell,
                 double longest) {
  const Vec3 e = sheet.normal.unitOrthogonal(), f = sheet.normal.cross(e);
  std::vector<Vec2> on, over;
  for (const Vec3& p : points) {
    const double above = sheet.above(p);
    if (above > kOver * longest) continue;
    (sheet.takes(p) ? on : over).emplace_back(e.dot(p), f.dot(p));
  }
  if (on.size() < kFewest) return false;
  const std::array<double, 2> extents = {
      quantile_of(on, 0.95, [](const Vec2& p) { return p.x(); }) -
          quantile_of(on, 0.05, [](const Vec2& p) { return p.x(); }),
      quantile_of(on, 0.95, [](const Vec2& p) { return p.y(); }) -
          quantile_of(on, 0.05, [](const Vec2& p) { return p.y(); })};
  if (std::min(extents[0], extents[1]) < kWide * longest) return false;
  return static_cast<double>(outside_of_hulls(on, over, 2 * cell)) >
         kFree * static_cast<double>(on.size());
}

double longest_side(std::span<const Vec3> points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

}  // namespace

std::optional<OuterSheet> find_outer_sheet(std::span<const Vec3> points, double cell) {
  if (points.size() < kFewest) return std::nullopt;
  std::vector<Vec3> some;
  const std::size_t step = points.size() / kDirectionsAt + 1;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  const double width = 2 * kBand * cell;
  OuterSheet sheet;
  Band best;
  std::vector<double> heights;
  for (const Vec3& direction : all_directions()) {
    const Band band = fullest_band(some, direction, width, heights);
    const auto allowed = static_cast<std::size_t>(kBeyond * static_cast<double>(band.count));
    if (band.count <= best.count || band.beyond > allowed) continue;
    best = band;
    sheet = {direction, band.middle, width};
  }
  for (const double within : {2.0 * width, width, width / 2}) {
    sheet = fit_plane(points, sheet, within);
  }
  sheet.thickness = width / 2;
  std::size_t on = 0, beyond = 0;
  for (const Vec3& p : points) {
    on += std::abs(sheet.above(p)) <= sheet.thickness ? 1 : 0;
    beyond += sheet.above(p) < -sheet.thickness ? 1 : 0;
  }
  const auto count = static_cast<double>(on);
  if (on < kFewest || count < kShare * static_cast<double>(points.size()) ||
      static_cast<double>(beyond) > kBeyond * count ||
      !reaches_out(points, sheet, cell, longest_side(points))) {
    return std::nullopt;
  }
  return sheet;
}

OuterSheet refine_sheet(OuterSheet sheet, std::span<const Vec3> points, double cell) {
  constexpr double kThinnest = 0.125, kThickest = 0.5;  // of a cell
  constexpr double kScatter = 6.0;  // times the median distance: four standard deviations
  for (const double within : {0.5 * cell, 0.25 * cell}) {
    sheet = fit_plane(points, sheet, within);
  }
  std::vector<double> distances;
  for (const Vec3& p : points) {
    const double distance = std::abs(sheet.above(p));
    if (distance < kThickest * cell) distances.push_back(distance);
  }
  sheet.thickness = std::clamp(kScatter * quantile(std::move(distances), 0.5), kThinnest * cell,
                               kThickest * cell);
  return sheet;
}

}  // namespace regarment
