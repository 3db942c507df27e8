#include "analysis/analyze.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "garment/springs.h"
#include "geometry/point_tree.h"
#include "measure/garment_region.h"
#include "measure/lay_on_scan.h"
#include "measure/observe.h"
#include "placement/place_garment.h"
#include "segmentation/caps.h"
#include "segmentation/segment.h"

namespace regarment {
namespace {

constexpr double kNormal90 = 1.645;      // half width of a 90 % interval in standard deviations
constexpr double kFabricStretch = 0.05;  // tight cloth is worn up to this much longer than flat
constexpr double kCloudSpacing =
    1.75;                             // mean spacing over median distance to the nearest neighbour
constexpr double kLeastLength = 0.5;  // of the template's shortest: two edges nearer are one
constexpr std::size_t kMostGarments = 8;

/// What all garments of a scan share.
struct Stage {
  const AnalyzeOptions& options;
  SurfaceSamples samples;
  Body body;
  std::vector<BodyPart> parts;      // per vertex
  std::vector<std::uint8_t> taken;  // per sample: belongs to a garment found before
  Labels labels;
};

/// Is this length a tight one, worn longer than flat? Waists, hips and whatever is measured below a
/// waist.
bool is_tight(const ObservedLength& o, const GarmentEdges& edges) {
  const auto edge = edges.edges.find(o.observation->edge);
  return edge != edges.edges.end() && edge->second.limb == "torso" && !edge->second.garment_above &&
         o.observation->kind != Observation::Kind::Path;
}

Measurement measurement_of(const Dimension& d, const SolvedDimension& solved,
                           const std::vector<ObservedLength>& observed, const GarmentEdges& edges) {
  Measurement m;
  m.name = d.name, m.code = d.code;
  m.flat = solved.value;
  m.observable = solved.observable;
  m.low = std::max(d.lower, m.flat - kNormal90 * solved.standard_deviation);
  m.high = std::min(d.upper, m.flat + kNormal90 * solved.standard_deviation);
  if (!solved.observable) {
    m.low = d.lower, m.high = d.upper;
    return m;
  }
  double sum = 0, weight = 0;
  for (const ObservedLength& o : observed) {
    if (!o.seen || o.observation->equals != d.name) continue;
    const double w = 1 / (o.standard_deviation * o.standard_deviation);
    sum += w * o.value, weight += w;
    if (is_tight(o, edges))
      m.low =
          std::min(m.low, m.flat * (1 - kFabricStretch) - kNormal90 * solved.standard_deviation);
  }
  m.worn = weight > 0 ? sum / weight : solved.value;
  return m;
}

std::vector<std::uint8_t> cloth_of(const Stage& stage, const GarmentRegion& region) {
  std::vector<std::uint8_t> cloth(stage.samples.size(), 0);
  for (std::size_t s = 0; s < cloth.size(); ++s)
    cloth[s] =
        stage.taken[s] == 0 && region.depth(stage.samples.positions[s], stage.body.part[s]) > 0;
  return cloth;
}

/// Heights for the placement; an edge hidden by another garment lies as far from the opposite edge
/// as the garment is long.
PlacementTarget placement_target(const GarmentEdges& edges, const Pattern& pattern) {
  PlacementTarget target;
  target.limbs = &edges.limbs;
  for (const auto& [name, edge] : edges.edges) target.edge_s[name] = edge.found.s;
  for (const auto& [name, edge] : edges.edges) {
    if (!edge.covered) continue;
    double t_low = 1e9, t_high = -1e9, mean = 0, n = 0;
    for (const Vec2& p : pattern.flat)
      t_low = std::min(t_low, p.y()), t_high = std::max(t_high, p.y());
    for (const auto& [other_name, other] : edges.edges)
      if (other.limb == edge.limb && !other.covered)
        for (double s : other.found.s) mean += s, n += 1;
    if (n == 0) continue;
    const double s = mean / n + (edge.garment_above ? -1 : 1) * (t_high - t_low);
    target.edge_s[name].assign(edge.found.s.size(), s);
  }
  return target;
}

void describe_edges(const GarmentEdges& edges, GarmentAnalysis& out) {
  for (const auto& [name, edge] : edges.edges) {
    const LimbView& view = edges.limbs.at(edge.limb);
    EdgeCurve curve;
    curve.name = name;
    curve.points = edge_points(edge.found, view.map, view.axis);
    curve.standard_error = edge.found.standard_error;
    curve.coverage = edge.found.coverage;
    curve.evidence = edge.covered ? "covered" : edge.found.evidence;
    out.edges.push_back(std::move(curve));
  }
}

/// Mean distance of the laid garment to the scan, and mean length of its springs over rest length.
void judge_drape(const Stage& stage, const std::vector<std::uint8_t>& cloth, GarmentAnalysis& out) {
  std::vector<Vec3> positions;
  for (std::size_t s = 0; s < cloth.size(); ++s)
    if (cloth[s]) positions.push_back(stage.samples.positions[s]);
  if (positions.empty()) return;
  const PointTree tree(positions);
  const std::vector<double> areas = triangle_areas(out.pattern);
  double sum = 0, weight = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const Triangle& t = out.pattern.triangles[f];
    PointNeighbour nearest;
    const Vec3 middle = (out.draped[t[0]] + out.draped[t[1]] + out.draped[t[2]]) / 3;
    if (tree.nearest(middle, {&nearest, 1}) == 0) continue;
    sum += areas[f] * std::sqrt(nearest.squared_distance), weight += areas[f];
  }
  if (weight > 0) out.mean_distance = sum / weight;
  const std::vector<Spring> links = springs(out.pattern);
  double stretch = 0;
  for (const Spring& s : links)
    stretch += (out.draped[s.vertex_a] - out.draped[s.vertex_b]).norm() / s.rest_length;
  if (!links.empty()) out.mean_stretch = stretch / static_cast<double>(links.size());
}

std::string centimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f cm", 100 * metres);
  return text;
}

void warn_about(const GarmentTemplate& garment, const GarmentEdges& edges,
                const GarmentAnalysis& found, std::vector<std::string>& warnings) {
  for (const auto& [name, edge] : edges.edges) {
    if (edge.covered)
      warnings.push_back(garment.title() + ": its " + name +
                         " is covered by another garment; what depends on it is not measured");
    else if (edge.found.coverage < 0.7)
      warnings.push_back(garment.title() + ": its " + name + " shows on " +
                         std::to_string(static_cast<int>(100 * edge.found.coverage)) +
                         " % of the loop only; check the pictures");
  }
  const auto left = edges.edges.find("left_cuff"), right = edges.edges.find("right_cuff");
  if (edges.upper_body && (left == edges.edges.end() || right == edges.edges.end()))
    warnings.push_back(garment.title() + ": one sleeve is not seen; the other one stands for both");
  for (const Measurement& m : found.measurements) {
    const Dimension& d = garment.dimension(m.name);
    if (m.observable && (m.flat <= d.lower || m.flat >= d.upper))
      warnings.push_back(garment.title() + ": " + d.title + " ends at the bound of the template, " +
                         centimetres(m.flat) + "; it may be a different garment");
  }
}

/// A body's own shape may show two edges close together; no garment is that short.
void check_lengths(const GarmentTemplate& garment, const std::vector<ObservedLength>& observed) {
  for (const ObservedLength& o : observed) {
    if (!o.seen || o.observation->kind != Observation::Kind::Path) continue;
    for (const Dimension& d : garment.dimensions())
      if (d.name == o.observation->equals && o.value < kLeastLength * d.lower)
        throw NoGarmentError("no " + garment.name() + " on this scan: its " + o.observation->edge +
                             " and its " + o.observation->to_edge + " would lie only " +
                             centimetres(o.value) + " apart; ask for the garment that is worn");
  }
}

GarmentAnalysis analyze_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                                Stage& stage, std::vector<std::uint8_t>& cap,
                                std::vector<std::string>& warnings) {
  GarmentAnalysis out;
  out.template_name = garment.name();
  out.layer = layer;
  out.pattern = make_pattern(garment, garment.typical(), stage.options.pattern_edge_length);
  const GarmentEdges edges = find_garment_edges(
      stage.samples, stage.body, out.pattern, garment.name(),
      layer > 1 ? stage.taken : std::vector<std::uint8_t>{}, stage.options.placement.edges);
  const GarmentRegion region(edges, stage.body);
  const std::vector<std::uint8_t> cloth = cloth_of(stage, region);
  const std::vector<ObservedLength> observed =
      observe(stage.samples, stage.body, edges, cloth, garment);
  check_lengths(garment, observed);
  const auto solved = solve_dimensions(garment, observed);
  for (const Dimension& d : garment.dimensions()) {
    out.measurements.push_back(measurement_of(d, solved.at(d.name), observed, edges));
    out.dimensions[d.name] = solved.at(d.name).value;
  }
  out.dimensions = garment.nearest_possible(out.dimensions);
  move_pattern(garment, out.dimensions, out.pattern);
  out.placed = place_garment(out.pattern, placement_target(edges, out.pattern));
  describe_edges(edges, out);
  std::map<std::string, std::vector<Vec3>> curves;
  for (const EdgeCurve& e : out.edges)
    if (e.evidence != "covered") curves[e.name] = e.points;
  out.draped = lay_on_scan(out.pattern, out.placed, stage.samples, cloth, curves);
  judge_drape(stage, cloth, out);

  label_region(scan, stage.parts, region, layer, stage.labels);
  for (std::size_t s = 0; s < cloth.size(); ++s)
    if (cloth[s]) stage.taken[s] = 1;
  const std::vector<std::uint8_t> caps = find_caps(scan, edges);
  for (std::size_t f = 0; f < caps.size(); ++f) cap[f] = cap[f] != 0 || caps[f] != 0;
  out.vertices_labelled = static_cast<std::size_t>(std::count(
      stage.labels.label.begin(), stage.labels.label.end(), static_cast<std::uint8_t>(layer)));
  warn_about(garment, edges, out, warnings);
  return out;
}

}  // namespace

void AnalyzeOptions::check() const {
  if (!(pattern_edge_length >= 0.005 && pattern_edge_length <= 0.2))
    throw InvalidInput("AnalyzeOptions: pattern_edge_length must lie between 0.005 and 0.2 m");
  if (!(sample_spacing >= 0.001 && sample_spacing <= 0.05))
    throw InvalidInput("AnalyzeOptions: sample_spacing must lie between 0.001 and 0.05 m");
}

Analysis analyze(Scan scan, const std::vector<GarmentTemplate>& templates,
                 const AnalyzeOptions& options, const Progress& progress) {
  options.check();
  if (templates.empty())
    throw UsageError("no garment asked for; give --garment NAME, outermost first");
  if (templates.size() > kMostGarments)
    throw UsageError("more than 8 garments asked for; give the visible ones");
  Analysis analysis;
  analysis.method = "direct";
  Stopwatch watch;
  progress.report("place", 0.0);
  // A random cloud's nearest neighbours are half as far away as points in a regular grid would be.
  const double spacing =
      scan.mesh.is_cloud() ? kCloudSpacing * scan.facts.spacing : options.sample_spacing;
  Stage stage{options, sample_surface(scan.mesh, spacing, scan.outlier), {}, {}, {}, {}};
  stage.taken.assign(stage.samples.size(), 0);
  progress.report("place", 0.3);
  stage.body = find_body(stage.samples, scan.facts.height);
  apply_landmarks(options.placement, stage.body);
  stage.parts = vertex_parts(scan, stage.samples, stage.body);
  analysis.landmarks = stage.body.landmarks();
  analysis.times.push_back({"place", watch.lap()});
  analysis.cap.assign(scan.mesh.triangles.size(), 0);
  for (std::size_t g = 0; g < templates.size(); ++g) {
    progress.report("measure", static_cast<double>(g) / static_cast<double>(templates.size()));
    analysis.garments.push_back(analyze_garment(scan, templates[g], static_cast<int>(g) + 1, stage,
                                                analysis.cap, analysis.warnings));
  }
  for (std::size_t f = 0; f < analysis.cap.size(); ++f)
    if (analysis.cap[f])
      for (std::uint32_t v : scan.mesh.triangles[f]) stage.labels.probability[v] = 0.5F;
  progress.report("measure", 1.0);
  analysis.times.push_back({"measure", watch.lap()});
  analysis.labels = std::move(stage.labels.label);
  analysis.label_probability = std::move(stage.labels.probability);
  analysis.scan = std::move(scan);
  return analysis;
}

}  // namespace regarment
