#include "fill/fill_scan.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "fill/border_loops.h"
#include "fill/fill_cloud.h"
#include "fill/fill_outline.h"
#include "fill/hole_outlines.h"
#include "scan/weld.h"

namespace regarment {
namespace {

// Longer outlines are not closed: no hole of a person is so long, but a broken file's may be.
constexpr std::size_t kMostPoints = 20'000;
// Of a patch's area that must lie on the cloth away from its open edges, and that may lie where the
// scan has surface already: what stretches across the inside of a hem does not.
constexpr double kLeastOnCloth = 0.8, kMostCovered = 0.3;
constexpr double kOnCloth = 0.05;  // m from the patch's flat triangles to the cloth they become
constexpr double kCovered = 0.01;  // m from the scan

std::vector<EdgeLoop> edge_loops(const FillCloth& cloth) {
  std::vector<EdgeLoop> out;
  for (const std::vector<Vec3>& edge : cloth.edges)
    if (!edge.empty()) out.emplace_back(edge);
  return out;
}

/// A mesh welded: what its borders are.
struct WeldedMesh {
  Welded welded;
  std::vector<Triangle> triangles;       // over welded positions
  std::vector<std::uint32_t> vertex_of;  // per position: the first vertex that has it
};

WeldedMesh weld_mesh(const Mesh& scan) {
  WeldedMesh out;
  out.welded = weld(scan.positions);
  out.triangles = weld_triangles(scan.triangles, out.welded);
  out.vertex_of.assign(out.welded.positions.size(), Welded::kNone);
  for (std::uint32_t v = 0; v < scan.positions.size(); ++v) {
    const std::uint32_t p = out.welded.of_vertex[v];
    if (p != Welded::kNone && out.vertex_of[p] == Welded::kNone) out.vertex_of[p] = v;
  }
  return out;
}

double area_of(const std::array<Vec3, 3>& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }

std::array<Vec3, 3> corners_of(const Triangle& t, const HoleOutline& outline, const Patch& patch) {
  std::array<Vec3, 3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = t[k] < outline.points.size() ? outline.points[t[k]]
                                          : patch.inner[t[k] - outline.points.size()];
  return out;
}

/// Whether a patch is the cloth over a hole: it lies on the cloth, and the scan is not there.
bool is_cloth(const HoleOutline& outline, const Patch& patch, const ClosestPoint& cloth,
              const ClosestPoint& scan) {
  double all = 0, on_cloth = 0, covered = 0;
  ClosestFilter near_cloth, near_scan;
  near_cloth.max_distance = kOnCloth;
  near_scan.max_distance = kCovered;
  for (const Triangle& t : patch.triangles) {
    const std::array<Vec3, 3> corners = corners_of(t, outline, patch);
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    const double area = area_of(corners);
    all += area;
    if (cloth.closest(middle, near_cloth).found()) on_cloth += area;
    const ClosestHit hit = scan.closest(middle, near_scan);
    if (hit.found() && !hit.on_border) covered += area;
  }
  return on_cloth >= kLeastOnCloth * all && covered <= kMostCovered * all;
}

class MeshFiller {
 public:
  MeshFiller(const Mesh& scan, std::span<const std::uint8_t> labels)
      : welded_(weld_mesh(scan)),
        loops_(border_loops(welded_.triangles, welded_.welded.positions.size())) {
    out_.mesh.positions = scan.positions;
    out_.mesh.triangles = scan.triangles;
    for (const std::uint32_t v : welded_.vertex_of) labels_.push_back(labels[v]);
  }

  void fill(const FillCloth& cloth, std::uint8_t label) {
    if (loops_.empty() || cloth.triangles.empty()) return;
    const ClosestPoint surface(cloth.positions, cloth.triangles);
    const ClosestPoint scan(welded_.welded.positions, welded_.triangles);
    const std::vector<EdgeLoop> edges = edge_loops(cloth);
    for (const HoleOutline& outline :
         hole_outlines({welded_.welded.positions, loops_, labels_, label, edges})) {
      if (outline.points.size() > kMostPoints) continue;
      const std::optional<Patch> patch = fill_outline(outline.points, surface);
      if (patch && is_cloth(outline, *patch, surface, scan)) add(outline, *patch);
    }
  }

  FilledScan take() && {
    out_.filled.resize(out_.mesh.positions.size(), 1);
    std::fill_n(out_.filled.begin(), welded_.welded.of_vertex.size(), std::uint8_t{0});
    return std::move(out_);
  }

 private:
  void add(const HoleOutline& outline, const Patch& patch) {
    std::vector<std::uint32_t> index;
    const auto new_vertex = [&](const Vec3& p) {
      index.push_back(static_cast<std::uint32_t>(out_.mesh.positions.size()));
      out_.mesh.positions.push_back(p);
    };
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
      if (outline.vertices[i] == HoleOutline::kNew)
        new_vertex(outline.points[i]);
      else
        index.push_back(welded_.vertex_of[outline.vertices[i]]);
    }
    for (const Vec3& p : patch.inner) new_vertex(p);
    for (const Triangle& t : patch.triangles) {
      out_.mesh.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
      out_.area += area_of(corners_of(t, outline, patch));
    }
    ++out_.holes;
  }

  WeldedMesh welded_;
  std::vector<std::vector<std::uint32_t>> loops_;
  std::vector<std::uint8_t> labels_;  // per welded position
  FilledScan out_;
};

Mesh with_normals(const FillCloth& cloth) {
  Mesh out{cloth.positions, cloth.triangles, {}, {}};
  out.normals.assign(out.positions.size(), Vec3::Zero());
  for (const Triangle& t : out.triangles) {
    const Vec3 n = (out.positions[t[1]] - out.positions[t[0]])
                       .cross(out.positions[t[2]] - out.positions[t[0]]);
    for (const std::uint32_t v : t) out.normals[v] += n;
  }
  for (Vec3& n : out.normals) n.normalize();
  return out;
}

FilledScan fill_points(const Mesh& scan, std::span<const std::uint8_t> outlier,
                       const std::vector<FillCloth>& cloths, double spacing) {
  FilledScan out;
  out.mesh.positions = scan.positions;
  std::vector<Vec3> seen;
  for (std::size_t v = 0; v < scan.positions.size(); ++v)
    if (scan.positions[v].allFinite() && (outlier.empty() || outlier[v] == 0))
      seen.push_back(scan.positions[v]);
  // Outermost first: what an outer garment has closed, an inner one need not.
  for (const FillCloth& cloth : cloths) {
    const std::vector<Vec3> added =
        fill_cloud(seen, with_normals(cloth), edge_loops(cloth), spacing);
    out.mesh.positions.insert(out.mesh.positions.end(), added.begin(), added.end());
    seen.insert(seen.end(), added.begin(), added.end());
  }
  out.filled.assign(out.mesh.positions.size(), 1);
  std::fill_n(out.filled.begin(), scan.positions.size(), std::uint8_t{0});
  return out;
}

}  // namespace

FilledScan fill_scan(const Mesh& scan, std::span<const std::uint8_t> labels,
                     std::span<const std::uint8_t> outlier, const std::vector<FillCloth>& cloths,
                     double spacing) {
  if (!outlier.empty() && outlier.size() != scan.positions.size())
    throw InvalidInput("fill_scan: one outlier mark per vertex of the scan");
  if (labels.size() != scan.positions.size())
    throw InvalidInput("fill_scan: one label per vertex of the scan");
  if (scan.is_cloud()) return fill_points(scan, outlier, cloths, spacing);
  MeshFiller filler(scan, labels);
  for (std::size_t g = 0; g < cloths.size(); ++g)
    filler.fill(cloths[g], static_cast<std::uint8_t>(g + 1));
  return std::move(filler).take();
}

}  // namespace regarment
