#include "measure/rim.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace regarment {
namespace {

constexpr double kInside = 0.025,
                 kFlatFrom = 0.012;  // m from the edge: cloth that hangs as it does
constexpr double kBeyond = 0.008;    // m on the other side of the edge
constexpr double kSameSheet = 0.02;  // m across: what lies further in is a leg
constexpr double kBend = 0.35;       // of the normal, along the limb: the surface has turned by 20
                                     // degrees from how the cloth hangs
constexpr double kDrop = 0.012;      // m, steps from which on the edge hangs in the air
constexpr double kMostTurned = 0.9;  // share of turned samples that the rim reaches over
constexpr int kNeighbours = 2;       // columns on both sides that are looked at together
constexpr std::size_t kEnough = 5;   // samples of a kind

struct Sample {
  double inside = 0;   // m from the edge
  double outward = 0;  // of the normal, along the limb away from the garment
};

using Columns = std::vector<std::vector<Sample>>;

Columns near_edge(const SurfaceSamples& samples, const LimbView& view, double sign,
                  const FoundEdge& edge) {
  const int columns = view.map.columns;
  Columns out(columns);
  for (const int m : view.members) {
    const LimbPoint at = view.axis.locate(samples.positions[m]);
    const double turn = at.phi / (2 * std::numbers::pi) + 0.5;
    const int j = std::clamp(static_cast<int>(turn * columns), 0, columns - 1);
    const double inside = sign * (at.s - edge.s[j]);
    if (inside < -kBeyond || inside > kInside || std::abs(at.r - edge.r[j]) > kSameSheet) continue;
    out[j].push_back({inside, -sign * samples.normals[m].dot(view.axis.tangent(at.s))});
  }
  return out;
}

double quantile(std::vector<double> v, double share) {
  const auto at =
      v.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(v.size() - 1));
  std::nth_element(v.begin(), at, v.end());
  return *at;
}

/// How far the rim reaches into the garment at a column, m; 0 where there is none.
double rim_at(const Columns& columns, int j) {
  const int n = static_cast<int>(columns.size());
  std::vector<double> hanging, turned;
  for (int k = -kNeighbours; k <= kNeighbours; ++k)
    for (const Sample& s : columns[(j + k + n) % n])
      if (s.inside > kFlatFrom) hanging.push_back(s.outward);
  if (hanging.size() < kEnough) return 0;
  const double usual = quantile(std::move(hanging), 0.5);
  for (int k = -kNeighbours; k <= kNeighbours; ++k)
    for (const Sample& s : columns[(j + k + n) % n])
      if (s.inside <= kFlatFrom && s.outward > usual + kBend) turned.push_back(s.inside);
  if (turned.size() < kEnough) return 0;
  return std::clamp(quantile(std::move(turned), kMostTurned), 0.0, 0.01);
}

}  // namespace

void trim_rim(const SurfaceSamples& samples, const LimbView& view, bool garment_above,
              FoundEdge& edge) {
  const double sign = garment_above ? 1.0 : -1.0;
  const Columns columns = near_edge(samples, view, sign, edge);
  for (int j = 0; j < view.map.columns; ++j)
    if (edge.step[j] >= kDrop) edge.s[j] += sign * rim_at(columns, j);
}

}  // namespace regarment
