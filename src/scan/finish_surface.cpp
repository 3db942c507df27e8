#include "scan/finish_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "geometry/parallel.h"
#include "geometry/point_tree.h"
#include "scan/cloud_normals.h"
#include "scan/local_surface.h"
#include "scan/mesh_normals.h"

namespace regarment {
namespace {

constexpr std::size_t kMostPoints = 500'000;  // looked at one by one; of larger clouds a part
constexpr std::size_t kPlaces = 2000;         // where noise is measured
constexpr double kLonely = 4.0;               // times the usual gap: a point on no surface
constexpr double kScattered = 2.5;            // the same where neighbours lie on no plane either
constexpr double kOffPlane = 0.25;  // of the gap: neighbours on a surface lie nearer to its plane
constexpr double kMeshPixel = 1.3;  // of the sample's spacing

/// The points a cloud is judged by, neighbours in space near in the list. Which they are and their
/// order depends on where they are alone.
struct Chosen {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> index;  // in the full list
  double share = 1.0;                // of all
};

std::uint64_t scramble(const Vec3& p) {
  std::uint64_t h = 0x2545f4914f6cdd1du;
  for (int axis = 0; axis < 3; ++axis) {
    h = (h ^ std::bit_cast<std::uint64_t>(p[axis])) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h;
}

/// The lower 10 bits of a number, two free bits after each.
std::uint32_t spaced(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000ffu;
  bits = (bits | bits << 8) & 0x0300f00fu;
  bits = (bits | bits << 4) & 0x030c30c3u;
  return (bits | bits << 2) & 0x09249249u;
}

/// Place of a point along a curve that fills space; the cells are 1/1024 of 4 m.
std::uint32_t along_curve(const Vec3& p) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::clamp((p[axis] + 2) * 256, 0.0, 1023.0);
    code |= spaced(static_cast<std::uint32_t>(cell)) << axis;
  }
  return code;
}

/// Leaves out stray points, and of very many takes a part.
Chosen choose(std::span<const Vec3> points, std::span<const std::uint8_t> stray) {
  const std::size_t step = points.size() / kMostPoints + 1;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
  order.reserve(points.size() / step + 1);
  std::size_t eligible = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (stray[i] != 0) continue;
    ++eligible;
    if (step > 1 && scramble(points[i]) % step != 0) continue;
    order.emplace_back(along_curve(points[i]), i);
  }
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    const Vec3 &p = points[a.second], &q = points[b.second];
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  });
  Chosen chosen;
  chosen.points.reserve(order.size());
  chosen.index.reserve(order.size());
  for (const auto& [code, i] : order) {
    chosen.points.push_back(points[i]);
    chosen.index.push_back(i);
  }
  chosen.share =
      static_cast<double>(order.size()) / static_cast<double>(std::max<std::size_t>(eligible, 1));
  return chosen;
}

void measure_sampling(const Chosen& chosen, const PointTree& tree, ScanFacts& facts) {
  std::vector<std::uint32_t> places;
  const std::size_t step = std::max<std::size_t>(1, chosen.points.size() / kPlaces);
  for (std::size_t i = step / 2; i < chosen.points.size(); i += step) {
    places.push_back(static_cast<std::uint32_t>(i));
  }
  const auto quality = sampling_quality(chosen.points, tree, places);
  facts.spacing = quality.spacing * std::sqrt(chosen.share);
  facts.noise = quality.noise;
}

/// Do the nearest points of a point scatter in depth as much as about it? Sparsely seen surface is
/// still a surface, many stray points together are none.
bool scattered(std::span<const Vec3> points, const LocalSurface& surface, std::size_t i) {
  double sum = 0;
  for (const std::uint32_t other : surface.nearest[i]) {
    const double off = surface.normals[i].dot(points[other] - points[i]);
    sum += off * off;
  }
  const double allowed = kOffPlane * static_cast<double>(surface.gap[i]);
  return sum > static_cast<double>(LocalSurface::kKept) * allowed * allowed;
}

/// Points whose neighbours are far, seen both over the whole cloud and from where those neighbours
/// are, or so far that they do not make a surface.
std::vector<std::uint8_t> lonely(std::span<const Vec3> points, const LocalSurface& surface) {
  std::vector<float> gaps = surface.gap;
  std::nth_element(gaps.begin(), gaps.begin() + std::ssize(gaps) / 2, gaps.end());
  const double usual = static_cast<double>(gaps[gaps.size() / 2]);
  std::vector<std::uint8_t> flags(surface.gap.size(), 0);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const double gap = static_cast<double>(surface.gap[i]);
    if (gap <= kScattered * usual) continue;
    flags[i] = scattered(points, surface, i) ? 1 : 0;
    if (flags[i] != 0 || gap <= kLonely * usual) continue;
    std::array<float, LocalSurface::kKept> near{};
    for (std::size_t n = 0; n < near.size(); ++n) near[n] = surface.gap[surface.nearest[i][n]];
    std::nth_element(near.begin(), near.begin() + near.size() / 2, near.end());
    const bool sparse_all_round = gap < 1.5 * static_cast<double>(near[near.size() / 2]);
    flags[i] = sparse_all_round ? 0 : 1;
  }
  return flags;
}

/// The file's normals by welded position: those of the first vertex there.
std::vector<Vec3> given_normals(const RawSurface& raw, const Mesh& mesh) {
  if (mesh.normals.empty()) return {};
  std::vector<Vec3> given(raw.welded.positions.size(), Vec3::Zero());
  for (std::size_t v = mesh.positions.size(); v-- > 0;) {
    const std::uint32_t at = raw.welded.of_vertex[v];
    if (at == Welded::kNone || !mesh.normals[v].allFinite()) continue;
    given[at] = mesh.normals[v].stableNormalized();
  }
  return given;
}

/// Result per welded position.
struct Finished {
  std::vector<Vec3> normals;
  std::vector<std::uint8_t> outlier;
};

/// Gives points that were not chosen the normal of the nearest one that was.
void follow_chosen(const RawSurface& raw, const PointTree& tree, const LocalSurface& surface,
                   Finished& finished) {
  parallel_for(raw.welded.positions.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!finished.normals[i].isZero()) continue;
      PointNeighbour hit;
      tree.nearest(raw.welded.positions[i], {&hit, 1});
      finished.normals[i] = surface.normals[hit.index];
    }
  });
}

Finished finish_cloud(const RawSurface& raw, Scan& scan) {
  const Chosen chosen = choose(raw.welded.positions, raw.stray);
  const PointTree tree(chosen.points);
  measure_sampling(chosen, tree, scan.facts);
  LocalSurface surface = local_surface(chosen.points, tree);
  orient_outward(chosen.points, scan.facts.spacing / std::sqrt(chosen.share), surface);
  const std::vector<std::uint8_t> flags = lonely(chosen.points, surface);
  Finished finished{std::vector<Vec3>(raw.welded.positions.size(), Vec3::Zero()), raw.stray};
  for (std::size_t i = 0; i < chosen.index.size(); ++i) {
    finished.normals[chosen.index[i]] = surface.normals[i];
    finished.outlier[chosen.index[i]] |= flags[i];
  }
  follow_chosen(raw, tree, surface, finished);
  switch (prefer_given(given_normals(raw, scan.mesh), finished.normals)) {
    case GivenNormals::Flipped:
      scan.facts.findings.push_back({"inward_normals", Severity::Note,
                                     "The file's normals point inward", "They were turned", ""});
      break;
    case GivenNormals::Replaced:
      scan.facts.findings.push_back({"replaced_normals", Severity::Note,
                                     "The file's normals do not fit its points",
                                     "They were estimated again", ""});
      break;
    default:
      break;
  }
  return finished;
}

Finished finish_mesh(const RawSurface& raw, Scan& scan) {
  std::vector<std::uint32_t> source;
  std::vector<Triangle> triangles = weld_triangles(scan.mesh.triangles, raw.welded, &source);
  MeshEdges edges = find_edges(triangles, raw.welded.positions.size());
  const auto stray = [&](std::uint32_t v) { return raw.stray[v] != 0; };
  std::erase_if(edges.border, [&](const auto& edge) { return stray(edge[0]) || stray(edge[1]); });
  scan.facts.holes = count_holes(edges, raw.welded.positions.size());
  const Winding winding = outward_winding(raw.welded.positions, triangles, edges, raw.stray,
                                          raw.sample, kMeshPixel * raw.sample_spacing);
  std::size_t turned = 0, body = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool of_body = std::none_of(triangles[t].begin(), triangles[t].end(), stray);
    body += of_body ? 1 : 0;
    if (winding.turn[t] == 0) continue;
    turned += of_body ? 1 : 0;
    std::swap(triangles[t][1], triangles[t][2]);
    std::swap(scan.mesh.triangles[source[t]][1], scan.mesh.triangles[source[t]][2]);
  }
  if (2 * turned > body) {
    scan.facts.findings.push_back({"inward_normals", Severity::Note,
                                   "The file's triangles face inward", "They were turned", ""});
  } else if (turned > 0) {
    scan.facts.findings.push_back(
        {"mixed_normals", Severity::Note,
         counted(turned, "triangle faces", "triangles face") + " the other way than the rest",
         "They were turned to face outward", ""});
  }
  measure_sampling(raw.welded.positions, raw.stray, scan.facts);
  return {mesh_normals(raw.welded.positions, triangles), raw.stray};
}

}  // namespace

void measure_sampling(std::span<const Vec3> positions, std::span<const std::uint8_t> stray,
                      ScanFacts& facts) {
  const Chosen chosen = choose(positions, stray);
  measure_sampling(chosen, PointTree(chosen.points), facts);
}

void finish_surface(const RawSurface& raw, Scan& scan) {
  const Finished finished = scan.mesh.is_cloud() ? finish_cloud(raw, scan) : finish_mesh(raw, scan);
  const std::size_t vertices = scan.mesh.positions.size();
  scan.mesh.normals.assign(vertices, Vec3::UnitY());
  scan.outlier.assign(vertices, 1);
  scan.facts.outliers = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::uint32_t at = raw.welded.of_vertex[v];
    if (at != Welded::kNone) {
      scan.mesh.normals[v] = finished.normals[at];
      scan.outlier[v] = finished.outlier[at];
    }
    scan.facts.outliers += scan.outlier[v];
  }
}

}  // namespace regarment
