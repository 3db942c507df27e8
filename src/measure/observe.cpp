#include "measure/observe.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "measure/outline.h"
#include "measure/section.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
// Standard deviations of what a direct measurement cannot know: how far folds and hidden cloth hide
// length. A share of the length, and a length.
constexpr double kGirthShare = 0.012, kPathShare = 0.01, kLeastDeviation = 0.004;
constexpr double kTiltError = 1.5;  // m of girth for a metre of height of the waist (design notes)

constexpr double kSteepest = 3.5;  // m of girth per m, a full circle skirt has 2 pi
constexpr double kWaving = 1.5;    // m of doubt in a girth per m that its edge waves up and down
constexpr double kOutlineReach = 0.006;  // m, see outline_length
constexpr double kHalfSlice = 0.004;     // m, half the thickness of a slice that is outlined
constexpr double kWidestSlice = 0.6;     // m from its centre
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

struct Observer {
  const SurfaceSamples& samples;
  const Body& body;
  const GarmentEdges& edges;
  const std::vector<std::uint8_t>& cloth;  // per sample: 1 = on the garment

  std::vector<int> on_cloth(const std::vector<int>& members) const {
    std::vector<int> kept;
    for (int m : members)
      if (cloth[m]) kept.push_back(m);
    return kept;
  }

  /// Slices of thin scans are thicker, and their gaps wider.
  double half_slice() const { return std::max(kHalfSlice, 0.6 * samples.spacing); }
  double reach() const { return std::max(kOutlineReach, 1.2 * samples.spacing); }

  const GarmentEdge* edge(const std::string& name) const {
    const auto it = edges.edges.find(name);
    return it == edges.edges.end() ? nullptr : &it->second;
  }
  const LimbView& limb(const GarmentEdge& e) const { return edges.limbs.at(e.limb); }

  double slice_girth(const GarmentEdge& e, const EdgePlane& plane, double inside) const;
  EdgePlane plane_of(const GarmentEdge& e) const;
  ObservedLength girth(const Observation& o) const;
  ObservedLength girth_at_offset(const Observation& o) const;
  ObservedLength path(const Observation& o) const;
  ObservedLength fork(const Observation& o) const;
  double centre_path(const GarmentEdge& from, const GarmentEdge& to, double phi) const;
  Vec3 edge_point(const GarmentEdge& e, double phi) const;
};

Vec3 Observer::edge_point(const GarmentEdge& e, double phi) const {
  const LimbView& view = limb(e);
  const int n = view.map.columns;
  const int j = ((static_cast<int>(std::floor((phi + kPi) / (2 * kPi) * n)) % n) + n) % n;
  return view.axis.point({e.found.s[j], view.map.column_phi(j), e.found.r[j]});
}

/// Outline of the garment at a distance inside from the plane through an edge, m; 0 when too much
/// is missing. `plane` spans the slice: centre, two directions.
double Observer::slice_girth(const GarmentEdge& e, const EdgePlane& plane, double inside) const {
  const LimbView& view = limb(e);
  const Vec3 towards = e.garment_above == (plane.normal.dot(view.axis.tangent(e.found.s[0])) > 0)
                           ? plane.normal
                           : Vec3(-plane.normal);
  std::vector<Vec2> points;
  for (int m : view.members) {
    if (!cloth[m]) continue;
    const Vec3 d = samples.positions[m] - plane.centre;
    if (std::abs(d.dot(towards) - inside) < half_slice() &&
        d.squaredNorm() < kWidestSlice * kWidestSlice) {
      const Vec2 p(d.dot(plane.a), d.dot(plane.b));
      if (e.limb == "torso" || plane.near_edge(p)) points.push_back(p);
    }
  }
  double bridged = 0;
  const double length = outline_length(points, Vec2::Zero(), reach(), &bridged);
  return bridged < 0.4 ? length : 0.0;
}

EdgePlane Observer::plane_of(const GarmentEdge& e) const {
  const LimbView& view = limb(e);
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

double median_of(std::vector<double> v) {
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

double median_length(const std::vector<std::pair<double, double>>& slices) {
  std::vector<double> lengths;
  for (const auto& s : slices) lengths.push_back(s.second);
  return median_of(lengths);
}

/// Length at distance 0 on the line of median slope and median offset (Theil and Sen): a slice that
/// leaked through a hole does not count.
double value_at_edge(const std::vector<std::pair<double, double>>& slices) {
  std::vector<double> slopes, offsets;
  for (std::size_t i = 0; i < slices.size(); ++i)
    for (std::size_t j = i + 1; j < slices.size(); ++j)
      slopes.push_back((slices[j].second - slices[i].second) / (slices[j].first - slices[i].first));
  const double slope = slopes.empty() ? 0.0 : std::clamp(median_of(slopes), -kSteepest, kSteepest);
  for (const auto& s : slices) offsets.push_back(s.second - slope * s.first);
  return median_of(offsets);
}

/// The girth at the edge itself, from slices inside: a line through their lengths against their
/// distance from the edge, so that an edge that waves does not matter.
ObservedLength Observer::girth(const Observation& o) const {
  ObservedLength out{&o, 0, 0, false};
  const GarmentEdge* e = edge(o.edge);
  if (!e || e->covered || e->found.coverage < 0.5) return out;
  const EdgePlane plane = plane_of(*e);
  const bool torso = e->limb == "torso";
  std::vector<std::pair<double, double>> slices;
  for (int k = 0; k < (torso ? 7 : 4); ++k) {
    const double inside = plane.reach + 0.006 + 0.008 * k;
    const double length = slice_girth(*e, plane, inside);
    if (length > 0) slices.emplace_back(inside, length);
  }
  if (slices.size() < 2) return out;
  out.value = torso ? value_at_edge(slices) : median_length(slices);
  out.standard_deviation =
      std::hypot(kGirthShare * out.value, kTiltError * e->found.standard_error) + kLeastDeviation +
      0.05 * (1 - e->found.coverage) * out.value;
  // A hem that waves is longer than the level slices above it tell.
  out.standard_deviation += kWaving * plane.reach;
  if (!torso) out.standard_deviation += 0.02;  // the lower side of a sleeve often touches the torso
  out.seen = true;
  return out;
}

ObservedLength Observer::girth_at_offset(const Observation& o) const {
  ObservedLength out{&o, 0, 0, false};
  const GarmentEdge* e = edge(o.edge);
  if (!e || e->limb != "torso") return out;
  const LimbView& view = limb(*e);
  const double direction = e->garment_above ? 1.0 : -1.0;
  std::vector<Vec3> curve;
  if (o.side == "underarm") {
    const double armpit = std::min(body.armpit[0] > 0 ? body.armpit[0] : 1e9,
                                   body.armpit[1] > 0 ? body.armpit[1] : 1e9);
    if (armpit > 1e8) return out;
    const double y = armpit - 0.02 - o.offset;
    std::vector<Vec2> points;
    const Vec3 centre = view.axis.point({y, 0, 0});
    for (int m : view.members) {
      const Vec3 d = samples.positions[m] - centre;
      if (cloth[m] && std::abs(d.y()) < half_slice()) points.emplace_back(d.x(), d.z());
    }
    double bridged = 0;
    out.value = outline_length(points, Vec2::Zero(), reach(), &bridged);
    out.standard_deviation = (0.03 + bridged) * out.value + kLeastDeviation;
    out.seen = out.value > 0 && bridged < 0.4;
    return out;
  } else {
    if (e->covered) return out;
    // Along each meridian down the cloth until the offset is used up.
    for (int j = 0; j < view.map.columns; ++j) {
      double used = 0, last_s = e->found.s[j], last_r = e->found.r[j];
      int i = static_cast<int>(std::lround(view.map.row_of(last_s)));
      while (used < o.offset) {
        i += direction > 0 ? 1 : -1;
        if (i < 0 || i >= view.map.rows) break;
        const double passed = std::abs(view.map.row_s(i) - last_s);
        if (!view.map.has(i, j) && passed < 10 * view.map.step) continue;
        const double r = view.map.has(i, j) ? view.map.radius[view.map.index(i, j)] : last_r;
        // Steps of two centimetres, so that noise does not lengthen the way; the last is cut off.
        if (passed < 0.02) continue;
        const double way = std::hypot(passed, r - last_r);
        const double share = std::min(1.0, (o.offset - used) / way);
        used += way;
        last_s += share * (view.map.row_s(i) - last_s), last_r += share * (r - last_r);
      }
      if (i < 0 || i >= view.map.rows) continue;
      curve.push_back(view.axis.point({last_s, view.map.column_phi(j), last_r}));
    }
  }
  if (static_cast<int>(curve.size()) < view.map.columns * 2 / 3) return out;
  out.value = closed_length(curve, 2);
  out.standard_deviation = 2 * kGirthShare * out.value + kLeastDeviation;
  out.seen = true;
  return out;
}

/// Way over the surface in the half plane of the trunk's axis at angle `phi` between two edges.
double Observer::centre_path(const GarmentEdge& from, const GarmentEdge& to, double phi) const {
  const Vec3 a = edge_point(from, phi), b = edge_point(to, phi);
  const LimbView& view = edges.limbs.at("torso");
  const double middle = 0.5 * (a.y() + b.y());
  const Vec3 centre = view.axis.point({middle, 0, 0});
  const Vec3 out = std::cos(phi) * Vec3::UnitZ() + std::sin(phi) * Vec3::UnitX();
  const Section section =
      cut_section(samples, on_cloth(view.members), centre, Vec3::UnitY(), out, 0.008, 240);
  return section.length_between(a, b, centre + 0.2 * out);
}

ObservedLength Observer::path(const Observation& o) const {
  ObservedLength out{&o, 0, 0, false};
  const GarmentEdge *from = edge(o.edge), *to = edge(o.to_edge);
  if (!from || !to || from->covered || to->covered) return out;
  std::vector<double> ways;
  if (o.side == "centre") {
    ways = {centre_path(*from, *to, 0.0), centre_path(*from, *to, kPi)};
  } else if (o.side == "shoulder_point") {
    const LimbView& torso = edges.limbs.at("torso");
    for (const double side : {0.5 * kPi, -0.5 * kPi}) {
      const Vec3 shoulder = edge_point(*from, side);
      const double low = *std::min_element(to->found.s.begin(), to->found.s.end());
      const Vec3 centre(shoulder.x(), 0.5 * (shoulder.y() + low),
                        torso.axis.point({0.5 * (shoulder.y() + low), 0, 0}).z());
      const Section section = cut_section(samples, on_cloth(torso.members), centre, Vec3::UnitY(),
                                          Vec3::UnitZ(), 0.008, 240);
      for (const double z : {1.0, -1.0}) {
        // The hem where this plane meets it, in front and behind.
        double best = 1e9;
        Vec3 hem = centre;
        for (int j = 0; j < torso.map.columns; ++j) {
          const Vec3 p =
              torso.axis.point({to->found.s[j], torso.map.column_phi(j), to->found.r[j]});
          if (z * (p.z() - centre.z()) < 0 || std::abs(p.x() - centre.x()) >= best) continue;
          best = std::abs(p.x() - centre.x());
          hem = p;
        }
        if (best > 0.02) continue;
        ways.push_back(section.length_between(shoulder, hem, centre + 0.3 * z * Vec3::UnitZ()));
      }
    }
  } else if (o.side == "top") {
    const int side = to->limb == "left_arm" ? 0 : 1;
    const Vec3 neck = edge_point(*from, side == 0 ? 0.5 * kPi : -0.5 * kPi);
    const Vec3 cuff = edge_point(*to, 0.0);
    // Over the shoulder in the upright plane through both ends.
    const Vec3 along = (cuff - neck).normalized();
    Vec3 up = Vec3::UnitY() - Vec3::UnitY().dot(along) * along;
    up.normalize();
    const Vec3 centre = 0.5 * (neck + cuff) - 0.15 * up;
    std::vector<int> members = edges.limbs.at("torso").members;
    const std::vector<int>& arm = edges.limbs.at(to->limb).members;
    members.insert(members.end(), arm.begin(), arm.end());
    const Section section = cut_section(samples, on_cloth(members), centre, up, along, 0.01, 240);
    ways = {section.length_between(neck, cuff, centre + 0.3 * up)};
  }
  double sum = 0, n = 0;
  for (double w : ways)
    if (std::isfinite(w)) sum += w, n += 1;
  if (n == 0) return out;
  out.value = sum / n;
  out.standard_deviation = kPathShare * out.value + kLeastDeviation +
                           std::hypot(from->found.standard_error, to->found.standard_error);
  if (o.side != "centre")
    out.standard_deviation += 0.012;  // where neck and shoulder meet is hard to see
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

}  // namespace

std::vector<ObservedLength> observe(const SurfaceSamples& samples, const Body& body,
                                    const GarmentEdges& edges,
                                    const std::vector<std::uint8_t>& cloth,
                                    const GarmentTemplate& garment) {
  const Observer observer{samples, body, edges, cloth};
  std::vector<ObservedLength> out;
  for (const Observation& o : garment.observations()) {
    switch (o.kind) {
      case Observation::Kind::Girth:
        out.push_back(observer.girth(o));
        break;
      case Observation::Kind::GirthAtOffset:
        out.push_back(observer.girth_at_offset(o));
        break;
      case Observation::Kind::Path:
        out.push_back(observer.path(o));
        break;
      case Observation::Kind::Fork:
        out.push_back(observer.fork(o));
        break;
    }
  }
  return out;
}

}  // namespace regarment
