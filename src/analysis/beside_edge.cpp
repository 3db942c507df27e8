#include "analysis/beside_edge.h"

#include <algorithm>
#include <cmath>

#include "measure/outline.h"

namespace regarment {
namespace {

constexpr double kHalfSlab = 0.004;    // m, at least; wider for scans with few points
constexpr double kReach = 1.15;        // of the edge's own radius: further out lies something else
constexpr double kMostBridged = 0.1;   // of the outline
constexpr double kLeastPerson = 0.95;  // of the points
constexpr double kMostLonger = 1.2;    // times the edge's length
constexpr double kWideGap = 0.006;     // m, points closer than this belong together

struct Plane {
  Vec3 centre, normal;  // the normal leads away from the garment
  Vec3 across, along;   // unit vectors in the plane
};

Vec3 mean(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

double length_of(const std::vector<Vec3>& loop) {
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return length;
}

/// The cloth within 10 cm of the edge tells on which side of its plane the garment lies.
Vec3 cloth_near(const std::vector<Vec3>& draped, const std::vector<Vec3>& loop,
                const Vec3& centre) {
  double radius = 0.0;
  for (const Vec3& p : loop) radius = std::max(radius, (p - centre).norm());
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const Vec3& p : draped) {
    if ((p - centre).norm() > radius + 0.1) continue;
    sum += p;
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : centre;
}

std::optional<Plane> plane_of(const GarmentAnalysis& garment, const EdgeCurve& edge) {
  if (edge.points.size() < 3 || garment.draped.empty()) return std::nullopt;
  Plane plane;
  plane.centre = mean(edge.points);
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < edge.points.size(); ++i)
    area += (edge.points[i] - plane.centre)
                .cross(edge.points[(i + 1) % edge.points.size()] - plane.centre);
  if (area.norm() < 1e-6) return std::nullopt;
  plane.normal = area.normalized();
  const Vec3 cloth = cloth_near(garment.draped, edge.points, plane.centre);
  if ((cloth - plane.centre).dot(plane.normal) > 0.0) plane.normal = -plane.normal;
  plane.across = plane.normal.unitOrthogonal();
  plane.along = plane.normal.cross(plane.across);
  return plane;
}

/// Points of the scan in a slab beyond the edge, in the plane; nothing when too few are a person's.
std::vector<Vec2> person_beyond(const Analysis& analysis, const EdgeCurve& edge,
                                const Plane& plane) {
  const Scan& scan = analysis.scan;
  const double half = std::max(kHalfSlab, scan.facts.spacing);
  double radius = 0.0;
  for (const Vec3& p : edge.points) radius = std::max(radius, (p - plane.centre).norm());
  std::vector<Vec2> points;
  std::size_t others = 0;
  for (std::size_t v = 0; v < scan.mesh.positions.size(); ++v) {
    const Vec3 p = scan.mesh.positions[v] - plane.centre;
    if (!p.allFinite() || std::abs(p.dot(plane.normal) - kBesideEdge) > half) continue;
    if (!scan.outlier.empty() && scan.outlier[v] != 0) continue;
    if (!scan.invented.empty() && scan.invented[v] != 0) continue;
    const Vec2 q(p.dot(plane.across), p.dot(plane.along));
    if (q.norm() > kReach * radius) continue;
    if (analysis.labels[v] != 0) {
      ++others;
    } else {
      points.push_back(q);
    }
  }
  const auto all = static_cast<double>(points.size() + others);
  if (static_cast<double>(points.size()) < kLeastPerson * all) points.clear();
  return points;
}

}  // namespace

std::optional<double> girth_beside(const Analysis& analysis, const GarmentAnalysis& garment,
                                   const EdgeCurve& edge) {
  const std::optional<Plane> plane = plane_of(garment, edge);
  if (!plane) return std::nullopt;
  const std::vector<Vec2> points = person_beyond(analysis, edge, *plane);
  if (points.empty()) return std::nullopt;
  Vec2 centre = Vec2::Zero();
  for (const Vec2& p : points) centre += p / static_cast<double>(points.size());
  const double gap = std::max(kWideGap, 1.5 * analysis.scan.facts.spacing);
  const Outline outline = trace_outline(points, centre, gap);
  if (outline.points.empty() || outline.bridged > kMostBridged) return std::nullopt;
  const double length = outline.length();
  if (length > kMostLonger * length_of(edge.points)) return std::nullopt;
  return length;
}

}  // namespace regarment
