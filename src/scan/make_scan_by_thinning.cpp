#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "scan/finish_surface.h"
#include "scan/made_scan.h"
#include "scan/thin_mesh.h"

namespace regarment {
namespace {

constexpr double kClearly = 0.3;  // cosine: a triangle faces against its corners' normals
constexpr double kMixed = 0.02;   // share of triangles turned; fewer are creases and hidden parts

static_assert(ThinScan::kNone == ThinMesh::kNone);

/// Puts the file's mesh into the body frame, with the normals of the thin scan.
void move_mesh(const ThinScan& thin, Mesh& mesh) {
  const Eigen::Affine3d body_from_file = thin.scan.file_from_body.inverse();
  mesh.normals.assign(mesh.positions.size(), Vec3::UnitY());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::uint32_t at = thin.of_vertex[v];
    if (at == ThinScan::kNone) {
      mesh.positions[v].setZero();
      continue;
    }
    mesh.positions[v] = (body_from_file * mesh.positions[v]).eval();
    mesh.normals[v] = thin.scan.mesh.normals[at];
  }
}

/// Makes triangles face the way their corners do; returns how many were turned.
std::size_t turn_triangles(Mesh& mesh) {
  std::size_t turned = 0;
  for (auto& [a, b, c] : mesh.triangles) {
    const Vec3 area =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    const Vec3 normal = mesh.normals[a] + mesh.normals[b] + mesh.normals[c];
    // In a crease the normals, means over a cell, may lie anyhow.
    if (area.dot(normal) >= -kClearly * area.norm() * normal.norm()) continue;
    std::swap(b, c);
    ++turned;
  }
  return turned;
}

/// In place of what was said of the thin mesh, whose triangles may be turned by the thinning.
void note_turned(std::size_t turned, std::size_t triangles, ScanFacts& facts) {
  std::erase_if(facts.findings, [](const Finding& f) { return f.code == "mixed_normals"; });
  const double share =
      static_cast<double>(turned) / static_cast<double>(std::max(triangles, std::size_t{1}));
  if (share <= kMixed || share > 0.5) return;
  facts.findings.push_back(
      {"mixed_normals", Severity::Note,
       counted(turned, "triangle faces", "triangles face") + " the other way than the rest",
       "They were turned to face outward", ""});
}

void note_thinning(std::size_t before, std::size_t after, ScanFacts& facts) {
  facts.findings.push_back({"coarsened", Severity::Note,
                            "The scan has very many vertices (" + std::to_string(before) + ")",
                            "Worked on through a copy of " + std::to_string(after) +
                                "; every vertex of the file has its label",
                            ""});
}

}  // namespace

MadeScan make_scan_by_thinning(Mesh mesh_in_file_frame, const ScanOptions& options) {
  auto thin = std::make_shared<ThinScan>();
  ThinMesh thinned = thin_mesh(mesh_in_file_frame, options.most_vertices / 2);
  thin->of_vertex = std::move(thinned.of_vertex);
  Welded welded = weld(thinned.mesh.positions);
  MadeScan made = make_scan_itself(std::move(thinned.mesh), std::move(welded), options);
  thin->scan = std::move(made.scan);

  const std::size_t vertices = mesh_in_file_frame.positions.size();
  MadeScan whole{{}, std::vector<Belongs>(vertices, Belongs::Nowhere), std::move(made.sheets)};
  Scan& scan = whole.scan;
  scan.facts = thin->scan.facts;
  scan.file_from_body = thin->scan.file_from_body;
  scan.outlier.assign(vertices, 1);
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::uint32_t at = thin->of_vertex[v];
    if (at == ThinScan::kNone) continue;
    scan.outlier[v] = thin->scan.outlier[at];
    whole.belongs[v] = made.belongs[at];
  }
  scan.facts.outliers =
      static_cast<std::size_t>(std::count(scan.outlier.begin(), scan.outlier.end(), 1));
  scan.mesh = std::move(mesh_in_file_frame);
  move_mesh(*thin, scan.mesh);
  note_turned(turn_triangles(scan.mesh), scan.mesh.triangles.size(), scan.facts);
  measure_sampling(scan.mesh.positions, scan.outlier, scan.facts);
  note_thinning(vertices, thin->scan.mesh.positions.size(), scan.facts);
  scan.thin = std::move(thin);
  return whole;
}

}  // namespace regarment
