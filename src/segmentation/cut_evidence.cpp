#include "segmentation/cut_evidence.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/median.h"
#include "garment/particles.h"
#include "geometry/closest_point.h"
#include "geometry/parallel.h"
#include "geometry/point_tree.h"

namespace regarment {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr double kSurelyOff = 0.15;        // m from the garment at which nothing is its cloth
constexpr double kBorderStep = 0.005;      // m between points of the garment's border
constexpr double kMostInside = 0.1;        // m, deeper inside nothing changes
constexpr double kCovered = 0.008;         // m, a vertex this near covers the garment
constexpr double kCoveredAgreement = 0.5;  // cosine of its normal and the garment's
constexpr double kSharpness = 4;           // log-odds of a vertex right on the sheet
constexpr double kReachInErrors = 3;  // a drape that lies off the cloth takes in what is this far
constexpr double kNormalFromMedian = 1.4826;
constexpr double kFolded = 0.35;     // share of their distance that counts for folds outside of it
constexpr double kDeep = 0.02;       // m inside the edges seen: cloth, or what is under it
constexpr double kNearSheet = 0.02;  // m, up to here the sheet knows where its border is
constexpr double kDisagree = 0.03;   // m between sheet and edges: they mean different places
constexpr double kLostShare = 0.1;   // of borders lie somewhere else altogether,
constexpr double kLostError = 0.08;  // m from where they are thought to be
constexpr double kTurnedAway = 0.4;  // surface facing against it counts as further off by this
constexpr double kMostOdds = 8;
constexpr double kMostOnSheet = 4;  // odds of lying on the sheet say that much for cloth at most
constexpr double kSlope = 1.7;      // of a logistic that stands for a normal distribution
constexpr double kLeast = 3e-4;     // the least probability an edge gives

double logistic(double x) { return 1 / (1 + std::exp(-x)); }
double logit(double p) { return std::log(p / (1 - p)); }

/// The draped garment with its particles welded, so that seams are no borders.
struct Sheet {
  std::vector<Vec3> positions;       // per particle
  std::vector<Triangle> triangles;   // of particles
  std::vector<Vec3> border;          // points along its open edges
  std::vector<double> border_error;  // of each of them, m

  Sheet(const Pattern& pattern, const std::vector<Vec3>& draped, const CutOptions& options);
};

Sheet::Sheet(const Pattern& pattern, const std::vector<Vec3>& draped, const CutOptions& options)
    : positions(particle_positions(pattern, draped)), triangles(particle_triangles(pattern)) {
  for (const PatternEdge& edge : pattern.edges) {
    const auto said = options.edge_error.find(edge.name);
    const double error = said == options.edge_error.end() ? options.border_error : said->second;
    for (std::size_t i = 0; i < edge.vertices.size(); ++i) {
      const Vec3& a = draped[edge.vertices[i]];
      const Vec3& b = draped[edge.vertices[(i + 1) % edge.vertices.size()]];
      const int steps = std::clamp(static_cast<int>((b - a).norm() / kBorderStep), 1, 1000);
      for (int k = 0; k < steps; ++k) {
        border.emplace_back(a + (b - a) * k / steps);
        border_error.push_back(error);
      }
    }
  }
}

/// Per triangle: how much of the garment about it some vertex of the scan lies on, 0..1.
std::vector<double> coverage(const Sheet& sheet, const std::vector<std::uint8_t>& covered) {
  std::vector<double> share(covered.begin(), covered.end());
  // Twice from triangles to particles and back: what two rings about a triangle say.
  for (int ring = 0; ring < 2; ++ring) {
    std::vector<double> sum(sheet.positions.size(), 0.0), count(sheet.positions.size(), 0.0);
    for (std::size_t f = 0; f < share.size(); ++f)
      for (std::uint32_t p : sheet.triangles[f]) sum[p] += share[f], count[p] += 1;
    for (std::size_t f = 0; f < share.size(); ++f) {
      share[f] = 0;
      for (std::uint32_t p : sheet.triangles[f]) share[f] += sum[p] / count[p] / 3;
    }
  }
  return share;
}

}  // namespace

void CutOptions::check() const {
  const auto require = [](bool right, const char* field, double value) {
    if (!right)
      throw InvalidInput(std::string("CutOptions: ") + field + " is " + std::to_string(value));
  };
  require(sheet_reach > 0 && sheet_reach <= 1, "sheet_reach", sheet_reach);
  require(border_error > 0 && border_error <= 1, "border_error", border_error);
  require(smoothness >= 0 && smoothness <= 1000, "smoothness", smoothness);
  for (const auto& [name, error] : edge_error)
    require(error > 0 && error <= 1, ("edge_error of " + name).c_str(), error);
}

std::vector<SheetPoint> look_at_sheet(const Scan& scan, const std::vector<std::uint8_t>& skip,
                                      const Pattern& pattern, const std::vector<Vec3>& draped,
                                      const CutOptions& options) {
  const std::size_t n = scan.mesh.positions.size();
  SheetPoint nothing;
  nothing.border_error = options.border_error;
  std::vector<SheetPoint> out(n, nothing);
  const Sheet sheet(pattern, draped, options);
  const ClosestPoint surface(sheet.positions, sheet.triangles);
  if (surface.empty()) return out;
  const PointTree border(sheet.border);
  ClosestFilter close;
  close.max_distance = kSurelyOff;
  std::vector<std::uint32_t> nearest(n, ClosestHit::kNone);
  parallel_for(n, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (skip[v]) continue;
      const Vec3& p = scan.mesh.positions[v];
      const ClosestHit hit = surface.closest(p, close);
      if (!hit.found()) {
        out[v].trust = 1;  // however well the garment lies, this is none of it
        continue;
      }
      const double off = (p - hit.point).dot(hit.normal);
      nearest[v] = hit.element;
      SheetPoint& at = out[v];
      at.distance = hit.on_border ? std::abs(off) : std::sqrt(hit.squared_distance);
      at.outside = off > 0;
      at.agreement = hit.normal.dot(scan.mesh.normals[v]);
      PointNeighbour edge;
      const bool near = border.nearest(hit.point, {&edge, 1}, kMostInside) > 0;
      if (near) at.border_error = sheet.border_error[edge.index];
      at.inside = hit.on_border ? -std::sqrt(std::max(0.0, hit.squared_distance - off * off))
                  : near        ? std::sqrt(edge.squared_distance)
                                : kMostInside;
    }
  });
  std::vector<std::uint8_t> covered(sheet.triangles.size(), 0);
  for (std::size_t v = 0; v < n; ++v)
    if (nearest[v] != ClosestHit::kNone && out[v].distance < kCovered && out[v].inside > 0 &&
        out[v].agreement > kCoveredAgreement)
      covered[nearest[v]] = 1;
  const std::vector<double> share = coverage(sheet, covered);
  for (std::size_t v = 0; v < n; ++v)
    if (nearest[v] != ClosestHit::kNone) out[v].trust = share[nearest[v]];
  return out;
}

namespace {

/// Log-odds that a vertex lies inside the garment's border. Near the sheet its own border counts,
/// and the edges seen as much when both mean the same; elsewhere the edges alone.
double odds_of_border(const SheetPoint& at, double depth, double likeness) {
  const double away = std::max(at.distance, -at.inside) / kNearSheet;
  // Deep under the outermost surface the edges say nothing of folds: there the sheet is believed.
  const double trust = depth <= -kMostInside ? 1 : at.trust;
  const double near = likeness * trust * std::exp(-away * away);
  const double both =
      std::abs(depth - at.inside) < kDisagree ? 0.5 * (depth + at.inside) : at.inside;
  const double within = near * both + (1 - near) * depth;
  const double p = (1 - kLostShare) * logistic(kSlope * within / at.border_error) +
                   kLostShare * logistic(kSlope * within / kLostError);
  return logit(std::clamp(p, kLeast, 1 - kLeast));
}

/// How far the drape lies off the cloth, m, as a standard deviation: from the median distance of
/// what lies between the edges seen, most of which is cloth.
double typical_error(const std::vector<SheetPoint>& sheet, const std::vector<double>& depth) {
  std::vector<double> distance;
  for (std::size_t v = 0; v < sheet.size(); ++v)
    if (depth[v] > kDeep) distance.push_back(sheet[v].distance);
  return kNormalFromMedian * median(distance);
}

/// Log-odds that a vertex lies on the sheet. Where the sheet is not on the scan it says nothing.
double odds_of_sheet(const SheetPoint& at, double depth, double reach) {
  const double turned = 1 + kTurnedAway * std::max(0.0, -at.agreement);
  const double folded = at.outside && depth > kDeep ? kFolded : 1;
  const double odds = kSharpness * (1 - turned * folded * at.distance / reach);
  return at.trust * std::clamp(odds, -kMostOdds, kMostOnSheet) + (1 - at.trust) * kMostOnSheet;
}

}  // namespace

std::vector<float> cloth_odds(const Scan& scan, const std::vector<std::uint8_t>& skip,
                              const std::vector<BodyPart>& parts, const GarmentRegion& region,
                              const std::vector<SheetPoint>& sheet, const CutOptions& options) {
  std::vector<float> out(sheet.size(), static_cast<float>(-kMostOdds));
  std::vector<double> depth(sheet.size(), -1.0);
  parallel_for(sheet.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (!skip[v])
        depth[v] =
            std::clamp(region.depth(scan.mesh.positions[v], parts[v]), -kMostInside, kMostInside);
  });
  const double reach = std::max(options.sheet_reach, kReachInErrors * typical_error(sheet, depth));
  const double likeness = options.sheet_reach / reach;
  parallel_for(sheet.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (skip[v]) continue;
      // Cloth lies inside the border and on the sheet: both must hold.
      const double odds = -std::log(std::exp(-odds_of_border(sheet[v], depth[v], likeness)) +
                                    std::exp(-odds_of_sheet(sheet[v], depth[v], reach)));
      out[v] = static_cast<float>(std::clamp(odds, -kMostOdds, kMostOdds));
    }
  });
  return out;
}

}  // namespace regarment
