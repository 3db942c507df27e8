// Prints how long a garment takes to come to rest on scans named on the command line: from its
// placement (cold), and from its last drape after each dimension was changed a little (warm).
#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/stopwatch.h"
#include "drape/attraction_force.h"
#include "drape/bending_force.h"
#include "drape/drape.h"
#include "drape/spring_force.h"
#include "drape/time_step.h"
#include "garment/find_template.h"
#include "measure/garment_edges.h"
#include "measure/garment_region.h"
#include "measure/observe.h"
#include "placement/place_garment.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"
#include "segmentation/caps.h"

namespace {

using namespace regarment;

double milliseconds(Stopwatch& watch) { return 1e3 * watch.lap(); }

/// A garment on a scan as the direct method starts it.
struct Start {
  Scan scan;
  Dimensions dimensions;
  Pattern pattern;
  std::vector<Vec3> placed;
  std::vector<std::uint8_t> cap;
};

Start start_on(const char* file, const GarmentTemplate& garment, double edge_length) {
  Start out;
  out.scan = make_scan(read_mesh_sandboxed(file).mesh);
  const Mesh& mesh = out.scan.mesh;
  const double spacing = mesh.is_cloud() ? 1.75 * out.scan.facts.spacing : 0.006;
  const SurfaceSamples samples = sample_surface(mesh, spacing, out.scan.outlier);
  const Body body = find_body(samples, out.scan.facts.height);
  out.pattern = make_pattern(garment, garment.typical(), edge_length);
  const GarmentEdges edges = find_garment_edges(samples, body, out.pattern, garment.name(), {});
  const GarmentRegion region(edges, body);
  std::vector<std::uint8_t> cloth(samples.size(), 0);
  for (std::size_t s = 0; s < cloth.size(); ++s)
    cloth[s] = region.depth(samples.positions[s], body.part[s]) > 0;
  const auto observed = observe(samples, body, edges, cloth, garment);
  for (const auto& [name, solved] : solve_dimensions(garment, observed))
    out.dimensions[name] = solved.value;
  out.dimensions = garment.nearest_possible(out.dimensions);
  move_pattern(garment, out.dimensions, out.pattern);
  PlacementTarget target;
  target.limbs = &edges.limbs;
  for (const auto& [name, edge] : edges.edges) target.edge_s[name] = edge.found.s;
  out.placed = place_garment(out.pattern, target);
  out.cap = find_caps(out.scan, edges);
  return out;
}

ClosestPoint closest_points(const Start& start) {
  const Mesh& mesh = start.scan.mesh;
  if (mesh.is_cloud())
    return {std::span(mesh.positions), std::span(mesh.normals), start.scan.outlier};
  return {std::span(mesh.positions), std::span(mesh.triangles), start.cap};
}

void print(const char* what, double ms, const DrapeOutcome& o) {
  std::printf("  %-22s %7.1f ms %4d steps %3d again  %s  distance %6.2f mm  stretch %.4f\n", what,
              ms, o.steps, o.rejected, o.ending == DrapeEnding::CameToRest ? "rest " : "LIMIT",
              1e3 * o.mean_distance, o.mean_stretch);
}

/// What one step costs where the cloth lies now, the best of several.
void print_shares(const Cloth& cloth, const ClosestPoint& scan, const DrapeOptions& options) {
  std::vector<Vec3> forces(cloth.size(), Vec3::Zero());
  ForceJacobian jacobian = make_jacobian(cloth);
  TimeStep step(cloth);
  double query = 1e9, assembly = 1e9, solve = 1e9;
  for (int run = 0; run < 7; ++run) {
    Stopwatch watch;
    const std::vector<Attraction> targets = attract(cloth, scan, options.attraction);
    query = std::min(query, milliseconds(watch));
    jacobian.set_zero();
    std::fill(forces.begin(), forces.end(), Vec3::Zero());
    const auto add = [&](const auto& force) {
      force.add_forces(cloth, forces);
      force.add_jacobian(cloth, jacobian);
    };
    add(SpringForce{options.spring_stiffness, options.spring_damping});
    add(BendingForce{options.bending_stiffness, options.bending_damping});
    add(AttractionForce{options.attraction_stiffness, options.attraction_grip, targets});
    assembly = std::min(assembly, milliseconds(watch));
    for (Vec3& f : forces) f += Vec3(1e-4, 1e-4, 0);
    step.velocity_change(cloth, forces, jacobian, options.largest_step, options.solver_tolerance);
    solve = std::min(solve, milliseconds(watch));
  }
  const double all = (query + assembly + solve) / 100;
  std::printf(
      "  one step %.2f ms: queries %.0f %%, assembly %.0f %%, solve %.0f %% (%d iterations)\n",
      100 * all, query / all, assembly / all, solve / all, step.solver_iterations());
}

void measure(const GarmentTemplate& garment, const char* file, double edge_length) {
  const Start start = start_on(file, garment, edge_length);
  const ClosestPoint scan = closest_points(start);
  const DrapeOptions options;
  Pattern pattern = start.pattern;
  Cloth cloth = make_cloth(pattern, start.placed);
  std::printf("%s: %zu vertices, %zu triangles; %zu particles\n", file,
              start.scan.mesh.positions.size(), start.scan.mesh.triangles.size(), cloth.size());
  Stopwatch watch;
  DrapeOutcome outcome = drape(cloth, scan, options);
  print("cold", milliseconds(watch), outcome);
  const Dimensions usual = start.dimensions;
  double sum = 0, most = 0;
  int count = 0;
  for (const double factor : {1.0, 0.95, 1.05, 1.02})
    for (const Dimension& d : garment.dimensions()) {
      Dimensions other = usual;
      other[d.name] *= factor;
      move_pattern(garment, garment.nearest_possible(other), pattern);
      update_cloth(pattern, cloth);
      std::fill(cloth.velocities.begin(), cloth.velocities.end(), Vec3::Zero());
      watch.lap();
      outcome = drape(cloth, scan, options);
      const double ms = milliseconds(watch);
      print((d.name + " x " + std::to_string(factor).substr(0, 4)).c_str(), ms, outcome);
      sum += ms, most = std::max(most, ms), ++count;
    }
  std::printf("  warm: mean %.1f ms, longest %.1f ms\n", sum / count, most);
  print_shares(cloth, scan, options);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::printf("usage: drape_benchmark GARMENT EDGE_LENGTH_M SCAN...\n");
    return 2;
  }
  try {
    const GarmentTemplate garment = find_template(argv[1]);
    for (int i = 3; i < argc; ++i) measure(garment, argv[i], std::stod(argv[2]));
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_status();
  }
}
