#include "placement/place_garment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBand = 0.015;  // m, rows of a panel that share a half width

/// A height field without gaps: empty cells take the value between their neighbours round the limb,
/// empty rows that of the next row with data.
std::vector<double> filled_radius(const LimbMap& map) {
  std::vector<double> r = map.radius;
  std::vector<bool> row_known(map.rows, false);
  for (int i = 0; i < map.rows; ++i) {
    std::vector<int> known;
    for (int j = 0; j < map.columns; ++j)
      if (map.has(i, j)) known.push_back(j);
    if (static_cast<int>(known.size()) * 4 < map.columns) continue;
    row_known[i] = true;
    for (std::size_t k = 0; k < known.size(); ++k) {
      const int from = known[k], to = known[(k + 1) % known.size()];
      const int gap = (to - from + map.columns) % map.columns;
      for (int d = 1; d < gap; ++d)
        r[map.index(i, from + d)] =
            (r[map.index(i, from)] * (gap - d) + r[map.index(i, to)] * d) / gap;
    }
  }
  for (int i = 0; i < map.rows; ++i) {
    if (row_known[i]) continue;
    int nearest = -1;
    for (int k = 0; k < map.rows; ++k)
      if (row_known[k] && (nearest < 0 || std::abs(k - i) < std::abs(nearest - i))) nearest = k;
    for (int j = 0; j < map.columns; ++j)
      r[map.index(i, j)] = nearest < 0 ? 0.15 : r[map.index(nearest, j)];
  }
  return r;
}

/// Half widths of a panel by bands of t, for the share of the way from its middle to its side.
class HalfWidths {
 public:
  HalfWidths(const Pattern& pattern, int panel) {
    low_ = 1e9;
    double high = -1e9;
    for (std::size_t v = 0; v < pattern.flat.size(); ++v)
      if (pattern.panel[v] == panel)
        low_ = std::min(low_, pattern.flat[v].y()), high = std::max(high, pattern.flat[v].y());
    width_.assign(static_cast<std::size_t>((high - low_) / kBand) + 2, 0.0);
    for (const Triangle& t : pattern.triangles) {
      if (pattern.panel[t[0]] != panel) continue;
      for (int k = 0; k < 3; ++k) add(pattern.flat[t[k]], pattern.flat[t[(k + 1) % 3]]);
    }
  }
  double at(double t) const {
    const double x = std::clamp((t - low_) / kBand, 0.0, static_cast<double>(width_.size() - 1));
    return std::max(1e-3, width_[static_cast<std::size_t>(std::lround(x))]);
  }

 private:
  /// A side of a triangle widens every band it passes.
  void add(const Vec2& a, const Vec2& b) {
    const int pieces = 1 + static_cast<int>(2 * std::abs(a.y() - b.y()) / kBand);
    for (int k = 0; k <= pieces; ++k) {
      const Vec2 p = a + (b - a) * k / pieces;
      double& w = width_[static_cast<std::size_t>(std::lround((p.y() - low_) / kBand))];
      w = std::max(w, std::abs(p.x()));
    }
  }
  double low_ = 0;
  std::vector<double> width_;
};

struct Placer {
  const Pattern& pattern;
  const PlacementTarget& target;
  double clearance;
  std::map<std::string, std::vector<double>> radius;  // by limb
  std::vector<Vec3> out;

  const LimbView& limb(const std::string& name) const { return target.limbs->at(name); }
  double edge_at(const std::string& edge, const LimbMap& map, double phi) const;
  Vec3 on_limb(const std::string& name, double s, double phi) const;
  void place_torso(int panel);
  void place_sleeve(int panel);
};

double Placer::edge_at(const std::string& edge, const LimbMap& map, double phi) const {
  return target.edge_s.at(edge)[map.column_of(phi)];
}

Vec3 Placer::on_limb(const std::string& name, double s, double phi) const {
  const LimbView& view = limb(name);
  const int row =
      std::clamp(static_cast<int>(std::lround(view.map.row_of(s))), 0, view.map.rows - 1);
  const double r = radius.at(name)[view.map.index(row, view.map.column_of(phi))];
  return view.axis.point({s, std::remainder(phi, 2 * kPi), r + clearance});
}

/// Rows of the panel run between its upper and its lower edge on the trunk.
void Placer::place_torso(int panel) {
  const LimbView& torso = limb("torso");
  const HalfWidths half(pattern, panel);
  double t_low = 1e9, t_high = -1e9;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    if (pattern.panel[v] == panel)
      t_low = std::min(t_low, pattern.flat[v].y()), t_high = std::max(t_high, pattern.flat[v].y());
  std::string upper, lower;
  for (const PatternEdge& e : pattern.edges) {
    if (e.limb != "torso" && e.limb != "neck") continue;
    double mean = 0;
    for (int v : e.vertices) mean += pattern.flat[v].y() / static_cast<double>(e.vertices.size());
    (mean < 0.5 * (t_low + t_high) ? upper : lower) = e.name;
  }
  std::optional<double> neck_top;  // a neckline's highest points are the panel's t = 0
  if (!upper.empty() && target.limbs->count("neck") != 0 && target.edge_s.count(upper) != 0 &&
      std::any_of(pattern.edges.begin(), pattern.edges.end(),
                  [&](const PatternEdge& e) { return e.name == upper && e.limb == "neck"; })) {
    const LimbView& neck = limb("neck");
    double sum = 0;
    for (const double phi : {0.5 * kPi, -0.5 * kPi}) {
      const double s = edge_at(upper, neck.map, phi);
      const int row = std::clamp(static_cast<int>(neck.map.row_of(s)), 0, neck.map.rows - 1);
      sum +=
          0.5 *
          neck.axis.point({s, phi, radius.at("neck")[neck.map.index(row, neck.map.column_of(phi))]})
              .y();
    }
    neck_top = sum;
  }
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    if (pattern.panel[v] != panel) continue;
    const Vec2& p = pattern.flat[v];
    const double u = std::clamp(p.x() / half.at(p.y()), -1.0, 1.0) * 0.5 * kPi;
    const double phi = pattern.panel_is_front[panel] ? u : kPi - u;
    const double share = (p.y() - t_low) / (t_high - t_low);
    const double top = neck_top                          ? *neck_top
                       : target.edge_s.count(upper) != 0 ? edge_at(upper, torso.map, phi)
                                                         : 0.9 * torso.axis.s_max();
    const double bottom =
        target.edge_s.count(lower) != 0 ? edge_at(lower, torso.map, phi) : top - (t_high - t_low);
    out[v] = on_limb("torso", top + share * (bottom - top), phi);
  }
}

/// Along the arm by the distance from the cuff, round it by the share of the way from the sleeve's
/// upper to its lower side.
void Placer::place_sleeve(int panel) {
  const std::string& name = pattern.panel_limbs[panel];
  if (target.limbs->count(name) == 0) return;
  const LimbView& arm = limb(name);
  const PatternEdge* cuff = nullptr;
  for (const PatternEdge& e : pattern.edges)
    if (e.limb == name) cuff = &e;
  if (cuff == nullptr || target.edge_s.count(cuff->name) == 0) return;
  Vec2 upper(0, 1e9), lower(0, -1e9), middle = Vec2::Zero();
  for (const auto& segment : cuff->segments)
    for (int v : segment) {
      if (pattern.panel[v] != panel) continue;
      if (pattern.flat[v].y() < upper.y()) upper = pattern.flat[v];
      if (pattern.flat[v].y() > lower.y()) lower = pattern.flat[v];
    }
  double n = 0;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    if (pattern.panel[v] == panel) middle += pattern.flat[v], n += 1;
  middle /= n;
  const Vec2 across = (lower - upper).normalized();
  Vec2 inwards(-across.y(), across.x());
  if (inwards.dot(middle - upper) < 0) inwards = -inwards;
  std::vector<double> widest;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    if (pattern.panel[v] != panel) continue;
    const auto band =
        static_cast<std::size_t>(std::max(0.0, inwards.dot(pattern.flat[v] - upper)) / kBand);
    if (widest.size() <= band) widest.resize(band + 1, 1e-3);
    widest[band] = std::max(widest[band], across.dot(pattern.flat[v] - upper));
  }
  const double front = pattern.panel_is_front[panel] == (name == "left_arm") ? 1.0 : -1.0;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v) {
    if (pattern.panel[v] != panel) continue;
    const double inside = std::max(0.0, inwards.dot(pattern.flat[v] - upper));
    const double share = std::clamp(
        across.dot(pattern.flat[v] - upper) / widest[static_cast<std::size_t>(inside / kBand)], 0.0,
        1.0);
    const double phi = front * share * kPi;
    out[v] = on_limb(name, edge_at(cuff->name, arm.map, phi) - inside, phi);
  }
}

}  // namespace

void PlacementOptions::check() const {
  if (!(clearance >= 0 && clearance < 0.2))
    throw InvalidInput("PlacementOptions: clearance must lie between 0 and 0.2 m");
}

std::vector<Vec3> place_garment(const Pattern& pattern, const PlacementTarget& target,
                                const PlacementOptions& options) {
  options.check();
  if (target.limbs == nullptr || target.limbs->count("torso") == 0)
    throw InvalidInput("place_garment: no torso among the limbs");
  Placer placer{
      pattern, target, options.clearance, {}, std::vector<Vec3>(pattern.flat.size(), Vec3::Zero())};
  for (const auto& [name, view] : *target.limbs) placer.radius[name] = filled_radius(view.map);
  for (int panel = 0; panel < static_cast<int>(pattern.panel_names.size()); ++panel) {
    if (pattern.panel_limbs[panel] == "torso")
      placer.place_torso(panel);
    else
      placer.place_sleeve(panel);
  }
  // A seam's particle lies between where its panels would have it.
  std::vector<Vec3> sum(pattern.particle_count, Vec3::Zero());
  std::vector<double> count(pattern.particle_count, 0.0);
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    sum[pattern.particle[v]] += placer.out[v], count[pattern.particle[v]] += 1;
  for (std::size_t v = 0; v < pattern.flat.size(); ++v)
    placer.out[v] = sum[pattern.particle[v]] / count[pattern.particle[v]];
  return std::move(placer.out);
}

}  // namespace regarment
