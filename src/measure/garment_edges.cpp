#include "measure/garment_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "geometry/parallel.h"
#include "measure/covered_edge.h"
#include "measure/edge_choice.h"
#include "measure/find_cuff.h"
#include "measure/judge_edges.h"
#include "measure/rim.h"

namespace regarment {
namespace {

constexpr int kTrunkColumns = 144, kArmColumns = 40, kNeckColumns = 72;
constexpr double kTrunkStep = 0.004, kArmStep = 0.005, kNeckStep = 0.004;
constexpr double kSaidReach = 0.03;    // m about a height that a person gave
constexpr double kBridge = 1.2;        // radians of missing surface bridged for pieces cut off
constexpr double kLooseReach = 0.03;   // m from that surface at which a loose piece belongs to it
constexpr double kWaistStray = 0.012;  // m, a waist is cut straight
constexpr double kWaistTilt = 0.05;    // m, amplitude
constexpr double kWaistDip = 0.03;     // m, the side seams pull it down
constexpr double kFacing = 0.5;  // caps and bulges that close a hem face down, cloth faces out
constexpr double kFineSpacing = 0.0045;  // m between samples that fill the finest cells
constexpr double kLongestShirt = 0.34;   // of the height: lower hems are of something else
constexpr double kArmpitShare = 0.74;    // of the height; arms that touch the side hide it
constexpr double kArmReach = 0.16;       // m, samples further from an arm's axis are torso
// m, standard errors of edges that show all the way round
constexpr double kWaistError = 0.002, kHemError = 0.003, kNeckError = 0.006;
constexpr double kNeckSpread = 0.02;  // m, how far a neckline slips from where its pattern puts it
constexpr double kHandShare = 0.12;   // of the height: from wrist to fingertips
constexpr double kCuffBefore = 0.06;  // m, the shortest sleeve ends so far before the armpit
constexpr int kCandidates = 4;        // places where an edge may be that are compared
constexpr double kArmLead = 0.12;     // m of the shoulder before the armpit
// The lowest hem drops to the legs, those above it step down to other cloth.
constexpr double kUpperShare = 0.3;
constexpr double kRivalShare = 0.7;  // of the best edge's score that makes another edge a rival

std::vector<int> trunk_members(const Body& body, const std::vector<std::uint8_t>& taken,
                               bool want_taken) {
  std::vector<int> members;
  for (std::size_t s = 0; s < body.part.size(); ++s)
    if (body.part[s] == BodyPart::Trunk && (!taken.empty() && taken[s] != 0) == want_taken)
      members.push_back(static_cast<int>(s));
  return members;
}

/// Samples of an arm and of the shoulder above the armpit. Between the arm and the torso's side the
/// plane through the armpit halfway between both directions decides.
std::vector<int> arm_members(const SurfaceSamples& samples, const Body& body, const LimbAxis& axis,
                             int side, const std::vector<std::uint8_t>& taken) {
  const double sign = side == 0 ? 1.0 : -1.0;
  const Vec3 armpit(body.armpit_x[side], body.armpit[side], 0);
  Vec3 dividing = axis.tangent(0.0) + Vec3::UnitY();
  dividing.z() = 0;
  dividing.normalize();
  std::vector<int> members;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (!taken.empty() && taken[s] != 0) continue;
    const Vec3& p = samples.positions[s];
    const bool arm = body.part[s] == (side == 0 ? BodyPart::LeftArm : BodyPart::RightArm);
    if (!arm && (body.part[s] != BodyPart::Trunk || sign * (p.x() - armpit.x()) < -0.12 ||
                 p.y() < armpit.y() - 0.03))
      continue;
    Vec3 d = p - armpit;
    d.z() = 0;
    if (d.dot(dividing) < -0.003) continue;
    if (axis.locate(p).r < kArmReach) members.push_back(static_cast<int>(s));
  }
  return members;
}

/// Is the edge at the bottom of the garment (larger t than the garment's middle)?
bool at_bottom(const Pattern& pattern, const PatternEdge& edge) {
  double mean = 0, low = 1e9, high = -1e9;
  for (int v : edge.vertices)
    mean += pattern.flat[v].y() / static_cast<double>(edge.vertices.size());
  for (const Vec2& p : pattern.flat) low = std::min(low, p.y()), high = std::max(high, p.y());
  return mean > 0.5 * (low + high);
}

/// The best edge in a range, or a rival that lies beyond it in the direction preferred and has at
/// least `share` of its score.
FoundEdge find_with_rivals(const LimbMap& map, const EdgeSearch& search, bool prefer_higher,
                           double share = kRivalShare) {
  FoundEdge best = find_edge(map, search);
  const double wanted = share * best.score;
  FoundEdge found = best;
  for (int round = 0; round < 3 && found.found(); ++round) {
    EdgeSearch beyond = search;
    const auto [low, high] = std::minmax_element(found.s.begin(), found.s.end());
    if (prefer_higher)
      beyond.s_low = *high + 0.03;
    else
      beyond.s_high = *low - 0.03;
    if (beyond.s_high - beyond.s_low < 0.05) break;
    const FoundEdge rival = find_edge(map, beyond);
    if (!rival.found() || rival.score < wanted || rival.coverage < 0.9) break;
    found = rival;
  }
  return found;
}

/// Cells of a height field hold a sample or two: thin scans get larger ones.
struct Resolution {
  double scale;
  explicit Resolution(const SurfaceSamples& samples)
      : scale(std::max(1.0, samples.spacing / kFineSpacing)) {}
  double step(double finest) const { return finest * scale; }
  int columns(int most) const { return std::max(16, static_cast<int>(most / scale)); }
};

struct Finder {
  const SurfaceSamples& samples;
  const Body& body;
  const Pattern& pattern;
  const std::vector<std::uint8_t>& taken;
  const std::map<std::string, double>& said;
  bool another_below;
  Resolution fine;
  GarmentEdges out;

  double arm_low(int side) const;
  double below_armpits() const;
  EdgeSearch waist_search() const;
  void add_limbs();
  LimbView view_torso() const;
  LimbView view_arm(int side) const;
  LimbView view_neck(const LimbView& torso) const;
  std::optional<FoundEdge> find_top_of_other() const;
  GarmentEdge find_on_torso(const PatternEdge& edge) const;
  std::optional<Cuff> find_on_arm(const PatternEdge& edge) const;
  std::optional<GarmentEdge> find_on_neck(const PatternEdge& edge) const;
  void find_all();
  void find_folds();
};

/// Where the map of an arm begins: higher up the arm where it hides the armpit that its axis counts
/// from.
double Finder::arm_low(int side) const {
  return -kArmLead - std::max(0.0, kArmpitShare * body.height - body.armpit[side]);
}

LimbView Finder::view_torso() const {
  const LimbAxis trunk = trunk_axis(body);
  std::vector<int> members = trunk_members(body, taken, false);
  LimbMap map = make_limb_map(samples, members, trunk, 0.0, body.neck, fine.step(kTrunkStep),
                              fine.columns(kTrunkColumns), kFacing);
  // Holes in the scan cut pieces of cloth off: what lies on the surface between their neighbours
  // joins.
  const LimbView whole{trunk, map, {}};
  const std::size_t before = members.size();
  for (std::size_t s = 0; s < samples.size(); ++s)
    if (body.part[s] == BodyPart::Loose && (taken.empty() || taken[s] == 0) &&
        beside_torso(whole, samples.positions[s]))
      members.push_back(static_cast<int>(s));
  if (members.size() > before)
    map = make_limb_map(samples, members, trunk, 0.0, body.neck, fine.step(kTrunkStep),
                        fine.columns(kTrunkColumns), kFacing);
  return {trunk, std::move(map), std::move(members)};
}

LimbView Finder::view_arm(int side) const {
  const LimbAxis axis = arm_axis(body, side);
  std::vector<int> members = arm_members(samples, body, axis, side, taken);
  LimbMap map = make_limb_map(samples, members, axis, arm_low(side), axis.s_max(),
                              fine.step(kArmStep), fine.columns(kArmColumns));
  return {axis, std::move(map), std::move(members)};
}

LimbView Finder::view_neck(const LimbView& torso) const {
  const LimbAxis neck = neck_axis(body);
  std::vector<int> members;
  for (int m : torso.members)
    if (samples.positions[m].y() > body.neck - 0.25) members.push_back(m);
  LimbMap map = make_limb_map(samples, members, neck, 0.0, 0.26, fine.step(kNeckStep),
                              fine.columns(kNeckColumns), 0.1);
  return {neck, std::move(map), std::move(members)};
}

void Finder::add_limbs() {
  for (const std::string& limb : pattern.panel_limbs)
    out.upper_body = out.upper_body || limb != "torso";
  if (!out.upper_body) {
    out.limbs.emplace("torso", view_torso());
    return;
  }
  std::optional<LimbView> torso, neck;
  std::array<std::optional<LimbView>, 2> arms;
  const auto look_at_arms = [&] {
    for (int side = 0; side < 2; ++side)
      if (body.arms[side].present()) arms[side] = view_arm(side);
  };
  run_together({[&] { torso = view_torso(), neck = view_neck(*torso); }, look_at_arms});
  out.limbs.emplace("torso", std::move(*torso));
  out.limbs.emplace("neck", std::move(*neck));
  if (arms[0]) out.limbs.emplace("left_arm", std::move(*arms[0]));
  if (arms[1]) out.limbs.emplace("right_arm", std::move(*arms[1]));
}

/// The highest that an edge round the trunk alone may lie, m above the floor.
double Finder::below_armpits() const {
  return std::max({body.armpit[0], body.armpit[1], kArmpitShare * body.height}) - 0.03;
}

/// A waist: cloth on skin, somewhere between the hips and the chest.
EdgeSearch Finder::waist_search() const {
  EdgeSearch search;
  search.garment_above = false;
  search.s_low = 0.48 * body.height, search.s_high = below_armpits(), search.most_step = 0.015;
  search.least_error = kWaistError;
  search.straightness = kWaistStray, search.tilt = kWaistTilt, search.dip = kWaistDip;
  return search;
}

std::optional<FoundEdge> Finder::find_top_of_other() const {
  if (!out.upper_body) return std::nullopt;
  std::vector<FoundEdge> places = find_edges(out.limbs.at("torso").map, waist_search(), 1);
  if (places.empty()) return std::nullopt;
  return std::move(places.front());
}

GarmentEdge Finder::find_on_torso(const PatternEdge& edge) const {
  const LimbView& view = out.limbs.at("torso");
  GarmentEdge found;
  found.limb = "torso";
  found.garment_above = at_bottom(pattern, edge);
  EdgeSearch search;
  search.garment_above = found.garment_above, search.least_error = kHemError;
  const auto given = said.find(edge.name);
  if (given != said.end()) {
    search.s_low = given->second - kSaidReach, search.s_high = given->second + kSaidReach;
    found.found = find_edge(view.map, search);
  } else if (!found.garment_above) {
    std::vector<FoundEdge> places = find_edges(view.map, waist_search(), kCandidates);
    if (!places.empty()) settle(std::move(places), 0, &FoundEdge::score, found);
  } else if (out.upper_body) {
    search.s_low = kLongestShirt * body.height, search.s_high = below_armpits() + 0.06;
    found.found = find_with_rivals(view.map, search, true);
  } else {
    search.s_low = 0.05 * body.height, search.s_high = 0.5 * body.height;
    found.found = another_below ? find_with_rivals(view.map, search, true, kUpperShare)
                                : find_with_rivals(view.map, search, false);
  }
  if (found.found.found() && found.garment_above)
    trim_rim(samples, view, found.garment_above, found.found);
  if (!taken.empty() && found.found.found()) {
    const LimbMap hidden =
        make_limb_map(samples, trunk_members(body, taken, true), view.axis, 0.0, body.neck,
                      fine.step(kTrunkStep), fine.columns(kTrunkColumns), kFacing);
    cut_off_where_covered(view, hidden, found);
  }
  return found;
}

std::optional<Cuff> Finder::find_on_arm(const PatternEdge& edge) const {
  const auto limb = out.limbs.find(edge.limb);
  const auto given = said.find(edge.name);
  if (limb == out.limbs.end()) {
    if (given == said.end()) return std::nullopt;
    throw UsageError("--hint: " + edge.name + "_edge: the scan shows no arm there; leave it out");
  }
  const LimbView& view = limb->second;
  return find_cuff(
      view, edge.name, edge.limb,
      {view.map.s_low + kArmLead - kCuffBefore, view.axis.s_max() - kHandShare * body.height},
      given == said.end() ? std::nullopt : std::optional(given->second));
}

/// Where a neckline of this width and depth would lie on the shoulders: s per column of the map.
/// At the sides it is as far out as half its width; in front and behind it lies lower by its drop.
std::vector<double> expected_neckline(const LimbView& view, double half_width, double drop) {
  const LimbMap& map = view.map;
  const auto at = [&](int i, int j) {
    return view.axis.point({map.row_s(i), map.column_phi(j), map.radius[map.index(i, j)]});
  };
  const double middle = view.axis.point({0, 0, 0}).x();
  double shoulder = 0, sides = 0;
  for (const double phi : {0.5, -0.5}) {
    const int j = static_cast<int>((phi + 1) / 2 * map.columns);
    for (int i = 0; i < map.rows; ++i) {
      if (!map.has(i, j) || std::abs(at(i, j).x() - middle) < half_width) continue;
      shoulder += at(i, j).y(), sides += 1;
      break;
    }
  }
  std::vector<double> s(map.columns, 0.0);
  if (sides == 0) return {};
  shoulder /= sides;
  for (int j = 0; j < map.columns; ++j) {
    const double c = std::cos(map.column_phi(j));
    const double height = shoulder - drop * c * c;
    s[j] = j == 0 ? 0.12 : s[j - 1];
    // From outside inwards: the first row that is as high as the neckline.
    for (int i = map.rows - 1; i >= 0; --i) {
      if (!map.has(i, j) || at(i, j).y() < height) continue;
      s[j] = map.row_s(i);
      break;
    }
  }
  return s;
}

std::optional<GarmentEdge> Finder::find_on_neck(const PatternEdge& edge) const {
  const LimbView& view = out.limbs.at("neck");
  double left = -1e9, right = 1e9, low = -1e9, high = 1e9;
  for (int v : edge.vertices) {
    left = std::max(left, pattern.flat[v].x()), right = std::min(right, pattern.flat[v].x());
    low = std::max(low, pattern.flat[v].y()), high = std::min(high, pattern.flat[v].y());
  }
  GarmentEdge found;
  found.limb = "neck";
  found.garment_above = true;  // larger angle from straight up
  EdgeSearch search;
  search.centre = expected_neckline(view, 0.5 * (left - right), low - high);
  search.spread = kNeckSpread, search.least_error = kNeckError;
  search.s_low = 0.03, search.s_high = 0.24;
  search.most_step = 0.02;
  found.found = find_edge(view.map, search);
  if (!found.found.found()) return std::nullopt;
  return found;
}

/// All edges at once: each depends on the limbs alone.
void Finder::find_all() {
  const std::size_t n = pattern.edges.size();
  std::vector<std::optional<GarmentEdge>> found(n);
  std::vector<std::optional<Cuff>> cuff(n);
  std::optional<FoundEdge> top_of_other;
  const auto find = [&](std::size_t i) {
    const PatternEdge& edge = pattern.edges[i];
    if (edge.limb == "torso")
      found[i] = find_on_torso(edge);
    else if (edge.limb == "neck")
      found[i] = find_on_neck(edge);
    else
      cuff[i] = find_on_arm(edge);
  };
  parallel_for(n + 1, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i < n)
        find(i);
      else
        top_of_other = find_top_of_other();
    }
  });
  std::vector<Cuff> cuffs;
  for (std::size_t i = 0; i < n; ++i) {
    if (found[i]) out.edges.emplace(pattern.edges[i].name, std::move(*found[i]));
    if (cuff[i]) cuffs.push_back(std::move(*cuff[i]));
  }
  for (auto& [name, edge] : settled_cuffs(std::move(cuffs))) out.edges.emplace(name, edge);
  if (top_of_other) out.top_of_other = std::move(*top_of_other);
}

/// Folds that hang from the hem of a garment without sleeves.
void Finder::find_folds() {
  if (out.upper_body) return;
  const LimbView& torso = out.limbs.at("torso");
  double top = body.neck;
  for (const auto& [name, edge] : out.edges)
    if (edge.limb == "torso" && !edge.garment_above && edge.found.found())
      top = std::min(top, *std::min_element(edge.found.s.begin(), edge.found.s.end()));
  for (auto& [name, edge] : out.edges)
    if (edge.limb == "torso" && edge.garment_above && edge.found.found() && !edge.covered)
      edge.folds = find_hanging_folds(samples, body, torso, edge, taken, top);
}

}  // namespace

bool beside_torso(const LimbView& torso, const Vec3& p) {
  const LimbPoint at = torso.axis.locate(p);
  const double outer = outer_radius(torso.map, at.s, at.phi, kBridge);
  return outer > 0 && std::abs(at.r - outer) < kLooseReach;
}

GarmentEdges find_garment_edges(const SurfaceSamples& samples, const Body& body,
                                const Pattern& pattern, const std::string& title,
                                const std::vector<std::uint8_t>& taken,
                                const std::map<std::string, double>& said, bool another_below) {
  Finder finder{samples, body, pattern, taken, said, another_below, Resolution(samples), {}};
  finder.add_limbs();
  finder.find_all();
  judge_edges(finder.out, body, title, said);
  finder.find_folds();
  return std::move(finder.out);
}

}  // namespace regarment
