#include "analysis/spread.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace regarment {
namespace {

/// Per vertex of the whole scan the value of the thin one's, `other` where there is none.
template <typename T>
std::vector<T> spread(const std::vector<T>& values, const ThinScan& thin, T other) {
  std::vector<T> out;
  if (values.empty()) return out;
  out.reserve(thin.of_vertex.size());
  for (const std::uint32_t at : thin.of_vertex) {
    out.push_back(at == ThinScan::kNone ? other : values[at]);
  }
  return out;
}

/// Share of the triangles at each thin vertex that are caps.
std::vector<float> cap_shares(const std::vector<std::uint8_t>& cap, const Mesh& mesh) {
  std::vector<float> caps(mesh.positions.size(), 0), all(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      all[v] += 1;
      caps[v] += cap[t] != 0 ? 1.0F : 0.0F;
    }
  }
  for (std::size_t v = 0; v < caps.size(); ++v) caps[v] /= std::max(all[v], 1.0F);
  return caps;
}

std::vector<std::uint8_t> spread_caps(const std::vector<std::uint8_t>& cap, const ThinScan& thin,
                                      const Mesh& whole) {
  std::vector<std::uint8_t> out(whole.triangles.size(), 0);
  if (cap.empty()) return out;
  const std::vector<float> share = spread(cap_shares(cap, thin.scan.mesh), thin, 0.0F);
  for (std::size_t t = 0; t < out.size(); ++t) {
    const auto [a, b, c] = whole.triangles[t];
    out[t] = share[a] + share[b] + share[c] > 1.5F ? 1 : 0;
  }
  return out;
}

}  // namespace

Analysis spread_over(Analysis of_thin, Scan whole) {
  const ThinScan& thin = *whole.thin;
  Analysis analysis = std::move(of_thin);
  analysis.cap = spread_caps(analysis.cap, thin, whole.mesh);
  analysis.labels = spread<std::uint8_t>(analysis.labels, thin, 0);
  analysis.label_probability = spread(analysis.label_probability, thin, 1.0F);
  for (GarmentAnalysis& garment : analysis.garments) {
    garment.vertices_labelled = static_cast<std::size_t>(
        std::count(analysis.labels.begin(), analysis.labels.end(), garment.layer));
    garment.deviation = spread(garment.deviation, thin, std::numeric_limits<float>::quiet_NaN());
  }
  // What the thin scan's analysis noticed comes after what was known before.
  std::vector<Finding>& findings = analysis.scan.facts.findings;
  const auto known = static_cast<std::ptrdiff_t>(thin.scan.facts.findings.size());
  whole.facts.findings.insert(whole.facts.findings.end(),
                              std::make_move_iterator(findings.begin() + known),
                              std::make_move_iterator(findings.end()));
  analysis.scan = std::move(whole);
  return analysis;
}

}  // namespace regarment
