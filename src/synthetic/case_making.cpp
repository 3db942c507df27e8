#include "synthetic/case_making.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "garment/find_template.h"
#include "geometry/ply_writer.h"
#include "synthetic/case_body.h"
#include "synthetic/truth_dimensions.h"

namespace regarment {
namespace {

// m; cloth lies this deep in the body nowhere. Less than what the scanners' noise would show.
constexpr double kDeepest = 0.003;
// Streams of chance that are drawn from after the case itself.
constexpr std::uint32_t kScanStream = 0x40000000U;

// The scan as its file holds it, body frame.
struct Scanned {
  Mesh mesh;
  std::vector<std::uint8_t> labels;
  std::vector<std::vector<std::uint8_t>> seen;  // per garment, per particle
};

Scanned as_cloud(ScannedPerson scan, const CaseRecipe& recipe, Random& random) {
  thin_points(scan, recipe.spacing);
  shuffle_points(scan, random);
  Scanned out{std::move(scan.cloud), std::move(scan.labels), {}};
  out.mesh.normals.clear();
  return out;
}

Scanned as_surface(const ScannedPerson& scan, const CaseRecipe& recipe) {
  SurfacedPerson surface = recipe.kind == ScanKind::OpenMesh
                               ? reconstruct_open(scan, recipe.surface)
                               : reconstruct_closed(scan, recipe.surface);
  surface.mesh.normals.clear();
  return {std::move(surface.mesh), std::move(surface.labels), {}};
}

Scanned scan_case(const DressedPerson& person, const CaseRecipe& recipe) {
  Random random(recipe.seed, kScanStream + recipe.index);
  ScannedPerson scan = scan_person(person, recipe.scanner, random);
  apply_damage(recipe.faults, random, scan);
  std::vector<std::vector<std::uint8_t>> seen;
  for (std::size_t g = 0; g < person.garments.size(); ++g) {
    const auto label = static_cast<std::uint8_t>(g + 1);
    seen.push_back(seen_particles(scan, label, person.garments[g].particles.size()));
  }
  Scanned out = recipe.kind == ScanKind::Cloud ? as_cloud(std::move(scan), recipe, random)
                                               : as_surface(scan, recipe);
  out.seen = std::move(seen);
  return out;
}

std::string scan_ply(Mesh mesh, const Eigen::Affine3d& to_file) {
  into_file_frame(to_file, mesh);
  PlyWriter ply(mesh.positions.size());
  ply.positions(mesh.positions);
  if (!mesh.colours.empty()) ply.colours(mesh.colours);
  if (!mesh.is_cloud()) ply.triangles(mesh.triangles);
  return ply.bytes();
}

std::string garment_ply(const WornGarment& worn, const Eigen::Affine3d& to_file) {
  std::vector<Vec3> positions;
  positions.reserve(worn.pattern.flat.size());
  for (const int particle : worn.pattern.particle) {
    positions.emplace_back(to_file * worn.particles[static_cast<std::size_t>(particle)]);
  }
  return PlyWriter(positions.size())
      .positions(positions)
      .coordinates(worn.pattern.flat)
      .triangles(worn.pattern.triangles)
      .bytes();
}

GarmentTruth truth_of(const WornGarment& worn, const std::vector<std::uint8_t>& seen) {
  const GarmentTemplate garment = find_template(worn.template_name);
  return {worn.template_name, worn.dimensions, worn_dimensions(garment, worn),
          hidden_dimensions(garment, worn, seen)};
}

std::vector<std::size_t> count_labels(const std::vector<std::uint8_t>& labels,
                                      std::size_t garments) {
  std::vector<std::size_t> out(garments + 2, 0);
  for (const std::uint8_t label : labels) ++out[std::min<std::size_t>(label, garments + 1)];
  return out;
}

MadeCase finish(const CaseRecipe& recipe, const DressedPerson& person) {
  const Scanned scanned = scan_case(person, recipe);
  const Eigen::Affine3d to_file = file_from_body(recipe.frame);
  MadeCase out;
  out.truth.recipe = recipe;
  out.truth.has_colours = !scanned.mesh.colours.empty();
  out.truth.labels = count_labels(scanned.labels, person.garments.size());
  const std::string scan = scan_file(recipe);
  const std::string stem = scan.substr(0, scan.rfind('.'));
  out.files.push_back({scan, scan_ply(scanned.mesh, to_file)});
  out.files.push_back(
      {"truth/" + stem + ".labels.u8", std::string(scanned.labels.begin(), scanned.labels.end())});
  for (std::size_t g = 0; g < person.garments.size(); ++g) {
    const WornGarment& worn = person.garments[g];
    out.truth.garments.push_back(truth_of(worn, scanned.seen[g]));
    const std::string file = recipe.name() + ".garment" + std::to_string(g + 1) + ".ply";
    out.files.push_back({"truth/" + file, garment_ply(worn, to_file)});
  }
  return out;
}

}  // namespace

std::string refusal(const Dressing& dressing) {
  for (std::size_t g = 0; g < dressing.reports.size(); ++g) {
    const DressReport& report = dressing.reports[g];
    const std::string which = dressing.person.garments[g].template_name + ": ";
    if (!report.came_to_rest) return which + "did not come to rest";
    if (!(report.deepest <= kDeepest)) {
      return which + "lies " + std::to_string(std::lround(report.deepest * 1000)) +
             " mm inside what it lies on";
    }
  }
  return {};
}

MadeCase make_case(std::uint64_t seed, std::uint32_t index, const CaseWish& wish,
                   const DressOptions& options, const Progress& progress) {
  std::vector<std::string> given_up;
  for (std::uint32_t attempt = 0; attempt < CaseDice::kMostAttempts; ++attempt) {
    const CaseRecipe recipe = sample_case(seed, index, wish, attempt);
    const Dressing dressing = dress_person(dressing_poses(recipe.outfit, recipe.body),
                                           recipe.garments, options, progress);
    const std::string why = refusal(dressing);
    if (!why.empty()) {
      given_up.push_back(why);
      continue;
    }
    MadeCase out = finish(recipe, dressing.person);
    out.truth.given_up = std::move(given_up);
    return out;
  }
  throw UsageError("case " + std::to_string(index) + " of seed " + std::to_string(seed) +
                   ": nothing drawn could be worn (last: " + given_up.back() +
                   "); use another seed");
}

}  // namespace regarment
