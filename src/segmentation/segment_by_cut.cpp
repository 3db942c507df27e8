#include "segmentation/segment_by_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "segmentation/colour_odds.h"
#include "segmentation/islands.h"
#include "segmentation/minimum_cut.h"
#include "segmentation/scan_links.h"

namespace regarment {
namespace {

constexpr float kDecided = 5.0F;  // log-odds from which neighbours hardly overrule a vertex
constexpr double kIsland = 1e-3;  // m^2, smaller pieces go to what surrounds them
constexpr double kFirm = 1.5;     // mean log-odds from which they are none

/// How often a label of this margin was right, on 186 made people fitted by the method joint, edges
/// taken wrongly included (tests/benchmarks/label_reliability.py).
constexpr std::array<std::pair<double, double>, 8> kRight = {{{0, 0.55},
                                                              {1.5, 0.59},
                                                              {2.5, 0.68},
                                                              {3.5, 0.77},
                                                              {4.5, 0.86},
                                                              {5.5, 0.95},
                                                              {7, 0.985},
                                                              {11, 0.99}}};

/// Probability that a label is right by its margin: straight between the entries of kRight.
double probability(double margin) {
  if (margin <= kRight.front().first) return kRight.front().second;
  for (std::size_t k = 1; k < kRight.size(); ++k) {
    const auto [x, p] = kRight[k - 1];
    const auto [to, q] = kRight[k];
    if (margin <= to) return p + (q - p) * (margin - x) / (to - x);
  }
  return kRight.back().second;
}

void require(bool right, const std::string& what) {
  if (!right) throw InvalidInput("segment_by_cut: " + what);
}

void check_input(const Scan& scan, const std::vector<BodyPart>& parts, const Pattern& pattern,
                 const std::vector<Vec3>& draped, int layer, const Labels& labels) {
  const std::size_t n = scan.mesh.positions.size();
  require(layer >= 1 && layer <= 255, "layer " + std::to_string(layer) + ", must be 1..255");
  require(draped.size() == pattern.flat.size(),
          std::to_string(draped.size()) + " draped positions for " +
              std::to_string(pattern.flat.size()) + " pattern vertices");
  require(parts.size() == n && scan.mesh.normals.size() == n,
          "one body part and one normal per scan vertex");
  require(scan.outlier.empty() || scan.outlier.size() == n, "one outlier mark per scan vertex");
  require(labels.label.size() == labels.probability.size() &&
              (labels.label.empty() || labels.label.size() == n),
          "one label and probability per scan vertex");
}

/// How firmly a label stands, log-odds: what speaks for it at the vertex and among its neighbours.
std::vector<float> margins(const std::vector<float>& odds, const std::vector<CutLink>& links,
                           const std::vector<std::uint8_t>& cloth) {
  std::vector<float> margin(odds.size());
  for (std::size_t v = 0; v < odds.size(); ++v) margin[v] = cloth[v] ? odds[v] : -odds[v];
  for (const CutLink& link : links) {
    const float gain = cloth[link.a] == cloth[link.b] ? link.cost : -link.cost;
    margin[link.a] += gain, margin[link.b] += gain;
  }
  return margin;
}

}  // namespace

void segment_by_cut(const Scan& scan, const std::vector<BodyPart>& parts,
                    const GarmentRegion& region, const Pattern& pattern,
                    const std::vector<Vec3>& draped, int layer, const CutOptions& options,
                    Labels& labels) {
  options.check();
  check_input(scan, parts, pattern, draped, layer, labels);
  const std::size_t n = scan.mesh.positions.size();
  if (labels.label.empty()) {
    labels.label.assign(n, 0);
    labels.probability.assign(n, 1.0F);
  }
  std::vector<std::uint8_t> skip(n, 0);
  for (std::size_t v = 0; v < n; ++v)
    skip[v] = labels.label[v] != 0 || (!scan.outlier.empty() && scan.outlier[v] != 0);
  const std::vector<SheetPoint> sheet = look_at_sheet(scan, skip, pattern, draped, options);
  std::vector<float> odds = cloth_odds(scan, skip, parts, region, sheet, options);
  if (options.colour) add_colour_odds(scan, skip, odds);
  std::vector<std::uint8_t> open(n, 0);
  for (std::size_t v = 0; v < n; ++v) open[v] = skip[v] == 0 && std::abs(odds[v]) < kDecided;
  std::vector<CutLink> links = scan_links(scan, open);
  for (CutLink& link : links) link.cost *= static_cast<float>(options.smoothness);
  std::vector<std::uint8_t> cloth = minimum_cut(odds, links);
  if (scan.facts.spacing > 0) {
    const double least = kIsland / (scan.facts.spacing * scan.facts.spacing);
    remove_islands(links, odds, static_cast<std::size_t>(least), kFirm, cloth);
  }
  const std::vector<float> margin = margins(odds, links, cloth);
  for (std::size_t v = 0; v < n; ++v) {
    if (skip[v]) continue;
    if (cloth[v]) labels.label[v] = static_cast<std::uint8_t>(layer);
    labels.probability[v] = std::min(
        labels.probability[v], static_cast<float>(probability(static_cast<double>(margin[v]))));
  }
}

}  // namespace regarment
