#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/observer.h"
#include "measure/section.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGirthShare = 0.012, kLeastDeviation = 0.004;
constexpr double kWaving = 1.5;       // m of doubt in a girth per m that its edge waves up and down
constexpr double kWidestSlice = 0.6;  // m from its centre
// A plane through a cuff cuts the side of the body as well: what lies further out than this against
// the cuff is not the sleeve.
constexpr double kWiderSleeve = 1.12;
constexpr double kThickSleeve = 0.008;  // m

/// The plane an edge lies in, nearly.
struct EdgePlane {
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::UnitY(), a = Vec3::UnitX(), b = Vec3::UnitZ();
  double reach = 0;  // m, how far the edge reaches into the garment from its mean plane
  std::array<double, 36> radius{};  // m, of the edge, by angle from a towards b; 0: not seen there

  std::size_t bin(const Vec2& p) const {
    const double turn = (std::atan2(p.y(), p.x()) + kPi) / (2 * kPi);
    return std::min(radius.size() - 1,
                    static_cast<std::size_t>(turn * static_cast<double>(radius.size())));
  }
  /// Whether a point beside a cuff may belong to the sleeve, which widens a little from its edge
  /// on.
  bool near_edge(const Vec2& p) const {
    const double r = radius[bin(p)];
    return r <= 0 || p.norm() <= kWiderSleeve * r + kThickSleeve;
  }
};

/// Outline of the garment at a distance inside from the plane through an edge, m; 0 when too much
/// is missing. `plane` spans the slice: centre, two directions.
double slice_girth(const Observer& see, const GarmentEdge& e, const EdgePlane& plane,
                   double inside) {
  const LimbView& view = see.limb(e);
  const Vec3 towards = e.garment_above == (plane.normal.dot(view.axis.tangent(e.found.s[0])) > 0)
                           ? plane.normal
                           : Vec3(-plane.normal);
  std::vector<Vec2> points;
  for (int m : view.members) {
    if (!see.cloth[m]) continue;
    const Vec3 d = see.samples.positions[m] - plane.centre;
    if (std::abs(d.dot(towards) - inside) < see.half_slice() &&
        d.squaredNorm() < kWidestSlice * kWidestSlice) {
      const Vec2 p(d.dot(plane.a), d.dot(plane.b));
      if (e.limb == "torso" || plane.near_edge(p)) points.push_back(p);
    }
  }
  double bridged = 0;
  const double length = outline_length(points, Vec2::Zero(), see.reach(), &bridged);
  return bridged < 0.4 ? length : 0.0;
}

EdgePlane plane_of(const Observer& see, const GarmentEdge& e) {
  const LimbView& view = see.limb(e);
  const std::vector<Vec3> points = edge_points(e.found, view.map, view.axis);
  EdgePlane plane;
  for (const Vec3& p : points) plane.centre += p / static_cast<double>(points.size());
  plane.normal = view.axis.tangent(view.axis.locate(plane.centre).s);
  if (e.limb != "torso") {
    // A cuff is as plane as the cloth's edge; the torso's edges are cut level.
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Vec3& p : points) scatter += (p - plane.centre) * (p - plane.centre).transpose();
    const Vec3 normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
    plane.normal = normal.dot(plane.normal) < 0 ? Vec3(-normal) : normal;
  }
  plane.a = plane.normal.unitOrthogonal();
  plane.b = plane.normal.cross(plane.a);
  // Mean and reach of the edge across its plane: slices begin where the whole loop is cloth.
  const double sign =
      e.garment_above == (plane.normal.dot(view.axis.tangent(e.found.s[0])) > 0) ? 1.0 : -1.0;
  std::vector<double> height;
  for (const Vec3& p : points) height.push_back(sign * (p - plane.centre).dot(plane.normal));
  for (const Vec3& p : points) {
    const Vec2 at((p - plane.centre).dot(plane.a), (p - plane.centre).dot(plane.b));
    double& r = plane.radius[plane.bin(at)];
    r = std::max(r, at.norm());
  }
  std::sort(height.begin(), height.end());
  plane.reach = height[height.size() * 9 / 10];
  return plane;
}

}  // namespace

ObservedLength Observer::cuff_girth(const Observation& o, const GarmentEdge& e) const {
  ObservedLength out{&o, 0, 0, false};
  const EdgePlane plane = plane_of(*this, e);
  std::vector<double> slices;
  for (int k = 0; k < 4; ++k) {
    const double length = slice_girth(*this, e, plane, plane.reach + 0.006 + 0.008 * k);
    if (length > 0) slices.push_back(length);
  }
  if (slices.size() < 2) return out;
  out.value = median_of(slices);
  out.standard_deviation = kGirthShare * out.value + kLeastDeviation +
                           0.05 * (1 - e.found.coverage) * out.value + kWaving * plane.reach + 0.02;
  out.seen = true;
  return out;
}

ObservedLength Observer::fork(const Observation& o) const {
  ObservedLength out{&o, 0, 0, false};
  const GarmentEdge* cuff = edge(o.edge);
  if (!cuff) return out;
  const int side = cuff->limb == "left_arm" ? 0 : 1;
  if (body.armpit[side] <= 0) return out;
  const LimbView& view = limb(*cuff);
  const LimbPoint armpit = view.axis.locate(
      Vec3(body.armpit_x[side], body.armpit[side], view.axis.point({0, 0, 0}).z()));
  // A section through the armpit, leaning inwards at the top as an armhole does.
  const Vec3 bottom = view.axis.point({armpit.s, kPi, armpit.r});
  const Vec3 top = view.axis.point({armpit.s - 0.06, 0.0, 0.08});
  const Vec3 up = (top - bottom).normalized();
  const Vec3 across = view.axis.radial(armpit.s, 0.5 * kPi);
  const Section section =
      cut_section(samples, on_cloth(view.members), 0.5 * (top + bottom), up, across, 0.008, 90);
  std::vector<Vec3> curve;
  for (int bin = 0; bin < 90; ++bin)
    if (std::isfinite(section.r[bin])) curve.push_back(section.point(bin));
  if (curve.size() < 50) return out;
  out.value = closed_length(curve, 1);
  out.standard_deviation = 0.05 * out.value + 0.01;
  out.seen = true;
  return out;
}

}  // namespace regarment
