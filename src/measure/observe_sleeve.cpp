#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/median.h"
#include "measure/level_fit.h"
#include "measure/observer.h"
#include "measure/section.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGirthShare = 0.03, kLeastDeviation = 0.003;  // of a girth, and m
constexpr double kFirstSlice = 0.006, kSliceStep = 0.005;      // m inside from the edge
constexpr int kSlices = 6;
constexpr double kWaving = 1.0;  // m of doubt in a girth per m that its edge waves up and down
constexpr double kWidestSleeve = 0.3;  // m from its middle
// A plane through a cuff cuts the side of the body as well: what lies further out than this against
// the cuff is not the sleeve.
constexpr double kWiderSleeve = 1.12;
constexpr double kThickSleeve = 0.008;  // m
// A cuff whose edge is this much longer than slices beside it hangs into the armpit (more than the
// larger factor is a mistake), and is tucked in there: so much longer again than what shows of it.
constexpr double kHanging = 1.07, kMostHanging = 1.6, kTucked = 1.15, kTuckedShare = 0.09;
constexpr double kWellSeen = 0.7;    // of an edge
constexpr double kSmoothed = 1.015;  // what smoothing over three of forty columns takes off
constexpr double kBridgedShare = 0.3;
// Sleeve and trunk part a little below the end of the armhole: what that makes it too long (mean
// and deviation over made people), and how deep it can be against the girth of the chest.
constexpr double kForkShorter = 0.95, kForkShare = 0.1, kDeepest = 0.24;
constexpr int kArmholeBins = 90;
constexpr double kNudge = 1e-4;  // m, for the slopes of formulas

/// The plane of a cuff: the slices of a sleeve lie parallel to it.
struct CuffPlane {
  Vec3 centre = Vec3::Zero(), inwards = Vec3::UnitY();  // inwards: unit, into the garment
  Vec3 a = Vec3::UnitX(), b = Vec3::UnitZ();
  double reach = 0;                 // m, how far the edge reaches into the garment
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

CuffPlane plane_of(const Observer& see, const GarmentEdge& e) {
  const LimbView& view = see.limb(e);
  const std::vector<Vec3> points = edge_points(e.found, view.map, view.axis);
  CuffPlane plane;
  for (const Vec3& p : points) plane.centre += p / static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) scatter += (p - plane.centre) * (p - plane.centre).transpose();
  plane.inwards = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  const Vec3 along = view.axis.tangent(view.axis.locate(plane.centre).s);
  if ((plane.inwards.dot(along) > 0) != e.garment_above) plane.inwards = -plane.inwards;
  plane.a = plane.inwards.unitOrthogonal();
  plane.b = plane.inwards.cross(plane.a);
  std::vector<double> depth;
  for (const Vec3& p : points) {
    depth.push_back((p - plane.centre).dot(plane.inwards));
    const Vec2 at((p - plane.centre).dot(plane.a), (p - plane.centre).dot(plane.b));
    double& r = plane.radius[plane.bin(at)];
    r = std::max(r, at.norm());
  }
  std::sort(depth.begin(), depth.end());
  plane.reach = depth[depth.size() * 9 / 10];
  return plane;
}

/// Girths of a sleeve across it, close to its edge.
std::vector<LevelGirth> slices_of(const Observer& see, const GarmentEdge& e,
                                  const CuffPlane& plane) {
  std::vector<LevelGirth> out;
  for (int k = 0; k < kSlices; ++k) {
    const double inside = plane.reach + kFirstSlice + kSliceStep * k;
    std::vector<Vec2> points;
    for (const int m : see.limb(e).members) {
      const Vec3 d = see.samples.positions[m] - plane.centre;
      if (!see.cloth[m] || std::abs(d.dot(plane.inwards) - inside) >= see.half_slice()) continue;
      const Vec2 p(d.dot(plane.a), d.dot(plane.b));
      if (p.norm() < kWidestSleeve && plane.near_edge(p)) points.push_back(p);
    }
    const Outline outline = trace_outline(points, Vec2::Zero(), see.reach());
    if (!outline.points.empty() && outline.bridged < 0.5)
      out.push_back({inside, outline.length(), outline.bridged});
  }
  return out;
}

}  // namespace

ObservedLength Observer::cuff_girth(const Observation& o, const GarmentEdge& e) const {
  const CuffPlane plane = plane_of(*this, e);
  const std::vector<LevelGirth> slices = slices_of(*this, e, plane);
  if (slices.size() < 2) return {&o, 0, 0, false};
  std::vector<double> lengths;
  double bridged = 0;
  for (const LevelGirth& s : slices) {
    lengths.push_back(s.girth);
    bridged += s.bridged / static_cast<double>(slices.size());
  }
  // The edge itself is longer than plane slices where its lower side hangs into the armpit.
  const double across = median(lengths);
  const double along =
      kSmoothed * closed_length(edge_points(e.found, limb(e).map, limb(e).axis), 1);
  const bool hangs =
      e.found.coverage > kWellSeen && along > kHanging * across && along < kMostHanging * across;
  const double value = hangs ? kTucked * along : across;
  const double doubt = hangs ? kTuckedShare : kGirthShare + kBridgedShare * bridged;
  return {&o, value, doubt * value + kLeastDeviation + kWaving * plane.reach, true};
}

std::optional<ShoulderPoint> Observer::shoulder_point(const std::string& cuff) const {
  Dimensions dimensions = garment.typical();
  const Observation* upper = nullptr;
  std::string chest;
  for (const Observation& o : garment.observations()) {
    if (o.kind == Observation::Kind::Path && o.side == "top" && o.to_edge == cuff) upper = &o;
    if (o.kind != Observation::Kind::GirthAtOffset || o.side != "underarm") continue;
    const ObservedLength girth = girth_at_offset(o);
    if (girth.seen && dimensions.count(o.equals) != 0)
      chest = o.equals, dimensions[chest] = girth.value;
  }
  if (!upper || chest.empty() || !edge(upper->edge) || !edge(cuff)) return std::nullopt;
  // What is left of the upper edge without the sleeve, whose length counts in full.
  double start = garment.evaluate(upper->equals, dimensions);
  for (const Dimension& d : garment.dimensions()) {
    Dimensions longer = dimensions;
    longer[d.name] += kNudge;
    const double growth =
        garment.evaluate(upper->equals, longer) - garment.evaluate(upper->equals, dimensions);
    if (d.name != chest && growth > 0.5 * kNudge) start -= dimensions[d.name];
  }
  const UpperEdge way = upper_edge(*edge(upper->edge), *edge(cuff));
  const double end = way.section.angle_of(way.cuff);
  Vec3 last = way.neck;
  for (int bin = 0; bin < static_cast<int>(way.section.r.size()); ++bin) {
    const Vec3 p = way.section.point(bin);
    if (!std::isfinite(way.section.r[bin])) continue;
    const double angle = way.section.angle_of(p);
    if (angle < way.section.angle_of(way.neck) || angle > end) continue;
    const double step = (p - last).norm();
    if (step >= start && step > 0)
      return ShoulderPoint{last + start / step * (p - last), dimensions[chest]};
    start -= step;
    last = p;
  }
  return std::nullopt;
}

/// The armhole: round the cloth in the plane through the shoulder point and the place where sleeve
/// and trunk part.
ObservedLength Observer::fork(const Observation& o) const {
  const GarmentEdge* cuff = edge(o.edge);
  if (!cuff) return {&o, 0, 0, false};
  const int side = cuff->limb == "left_arm" ? 0 : 1;
  const std::optional<ShoulderPoint> shoulder = shoulder_point(o.edge);
  if (body.armpit[side] <= 0 || !shoulder) return {&o, 0, 0, false};
  const Vec3 underarm(body.armpit_x[side], body.armpit[side],
                      limb(*cuff).axis.point({0, 0, 0}).z());
  const double drop = (shoulder->at - underarm).norm();
  // An arm that touches the trunk parts from it far below the armhole.
  if (drop > kDeepest * shoulder->chest) return {&o, 0, 0, false};
  const Vec3 up = (shoulder->at - underarm) / drop;
  const Vec3 across = (Vec3::UnitZ() - Vec3::UnitZ().dot(up) * up).normalized();
  std::vector<int> members = edges.limbs.at("torso").members;
  const std::vector<int>& arm = limb(*cuff).members;
  members.insert(members.end(), arm.begin(), arm.end());
  const Section section = cut_section(samples, on_cloth(members), 0.5 * (shoulder->at + underarm),
                                      up, across, 0.008, kArmholeBins);
  // Beyond lies what the plane cuts of trunk and arm.
  const double widest = std::max(0.6 * drop, 0.08);
  std::vector<Vec3> curve;
  for (int bin = 0; bin < kArmholeBins; ++bin)
    if (section.r[bin] < widest) curve.push_back(section.point(bin));
  if (static_cast<int>(curve.size()) < kArmholeBins / 2) return {&o, 0, 0, false};
  const double value = kForkShorter * closed_length(curve, 1);
  return {&o, value, kForkShare * value, true};
}

}  // namespace regarment
