#include "analysis/stage.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <utility>

#include "base/error.h"
#include "garment/springs.h"
#include "geometry/closest_point.h"
#include "geometry/parallel.h"
#include "geometry/point_tree.h"
#include "measure/garment_region.h"

namespace regarment {

namespace {

constexpr double kLeastLength = 0.5;  // of the template's shortest: two edges nearer are one

/// Heights that a person gave for edges of this garment, by the edge's name.
std::map<std::string, double> said_of(const PlacementOverrides& placement,
                                      const std::string& garment) {
  std::map<std::string, double> out;
  const std::string own = garment + ".";
  for (const auto& [name, height] : placement.edges) {
    if (name.starts_with(own)) {
      out[name.substr(own.size())] = height;
    } else {
      out.emplace(name, height);
    }
  }
  return out;
}

GarmentEdges edges_on(const Stage& stage, const Pattern& pattern, const GarmentTemplate& garment,
                      int layer) {
  return find_garment_edges(stage.samples, stage.body, pattern, garment.name(),
                            layer > 1 ? stage.taken : std::vector<std::uint8_t>{},
                            said_of(stage.options.placement, garment.name()),
                            stage.another_below.at(static_cast<std::size_t>(layer - 1)));
}

std::vector<std::uint8_t> cloth_of(const Stage& stage, const GarmentRegion& region) {
  std::vector<std::uint8_t> cloth(stage.samples.size(), 0);
  parallel_for(cloth.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s)
      cloth[s] =
          stage.taken[s] == 0 && region.depth(stage.samples.positions[s], stage.body.part[s]) > 0;
  });
  return cloth;
}

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

}  // namespace

SeenGarment look_for(const GarmentTemplate& garment, const Pattern& pattern, int layer,
                     const Stage& stage) {
  return look_between(edges_on(stage, pattern, garment, layer), garment, stage);
}

SeenGarment look_between(GarmentEdges edges, const GarmentTemplate& garment, const Stage& stage) {
  std::vector<std::uint8_t> cloth = cloth_of(stage, GarmentRegion(edges, stage.body));
  std::vector<ObservedLength> observed = observe(stage.samples, stage.body, edges, cloth, garment);
  check_lengths(garment, observed);
  return {std::move(edges), std::move(cloth), std::move(observed)};
}

void check_stays_up(const GarmentTemplate& garment, const Dimensions& dimensions,
                    const GarmentEdges& edges, const Stage& stage) {
  if (edges.upper_body || !fixed_of(stage.options, garment).empty()) return;
  const auto said = said_of(stage.options.placement, garment.name());
  double top = 0, widest = 0;
  for (const Observation& o : garment.observations()) {
    if (o.kind != Observation::Kind::Girth && o.kind != Observation::Kind::GirthAtOffset) continue;
    const double girth = garment.evaluate(o.equals, dimensions);
    const auto edge = edges.edges.find(o.edge);
    if (edge == edges.edges.end()) continue;
    if (o.kind == Observation::Kind::GirthAtOffset || edge->second.garment_above) {
      widest = std::max(widest, girth);
    } else if (!edge->second.covered && said.count(o.edge) == 0) {
      top = std::max(top, girth);
    }
  }
  if (widest > 0 && top > widest)
    throw NoGarmentError("no " + garment.name() + " on this scan: its top edge would measure " +
                         centimetres(top) + " and what is below it at most " + centimetres(widest) +
                         ", so that it could not stay up; ask for the garment that is worn");
}

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

double mean_height(const std::vector<Vec3>& points) {
  double sum = 0;
  for (const Vec3& p : points) sum += p.y();
  return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

std::vector<EdgeCurve> edge_curves(const GarmentEdges& edges) {
  std::vector<EdgeCurve> out;
  for (const auto& [name, edge] : edges.edges) {
    const LimbView& view = edges.limbs.at(edge.limb);
    EdgeCurve curve;
    curve.name = name;
    curve.points = edge_curve(edge, view);
    curve.standard_error = edge.found.standard_error;
    curve.coverage = edge.found.coverage;
    curve.evidence = edge.covered ? "covered" : edge.found.evidence;
    if (edge.limb == "torso" && !edge.covered)
      for (const EdgeHypothesis& rival : edge.rivals)
        curve.rivals.push_back(
            {mean_height(edge_points(rival.edge, view.map, view.axis)), rival.weight});
    out.push_back(std::move(curve));
  }
  return out;
}

void judge_drape(const Stage& stage, const std::vector<std::uint8_t>& cloth, GarmentAnalysis& out) {
  std::vector<Vec3> positions;
  for (std::size_t s = 0; s < cloth.size(); ++s)
    if (cloth[s]) positions.push_back(stage.samples.positions[s]);
  if (positions.empty()) return;
  const PointTree tree(positions);
  const std::vector<double> areas = triangle_areas(out.pattern);
  std::vector<PointNeighbour> nearest(areas.size());
  parallel_for(areas.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Triangle& t = out.pattern.triangles[f];
      const Vec3 middle = (out.draped[t[0]] + out.draped[t[1]] + out.draped[t[2]]) / 3;
      tree.nearest(middle, {&nearest[f], 1});  // there are points, so that one is nearest
    }
  });
  double sum = 0, weight = 0;
  for (std::size_t f = 0; f < areas.size(); ++f)
    sum += areas[f] * std::sqrt(nearest[f].squared_distance), weight += areas[f];
  if (weight > 0) out.mean_distance = sum / weight;
  const std::vector<Spring> links = springs(out.pattern);
  double stretch = 0;
  for (const Spring& s : links)
    stretch += (out.draped[s.vertex_a] - out.draped[s.vertex_b]).norm() / s.rest_length;
  if (!links.empty()) out.mean_stretch = stretch / static_cast<double>(links.size());
}

std::vector<float> deviation_of(const Scan& scan, const GarmentAnalysis& garment,
                                const Labels& labels) {
  const ClosestPoint cloth{std::span(garment.draped), std::span(garment.pattern.triangles)};
  std::vector<float> out(scan.mesh.positions.size(), std::numeric_limits<float>::quiet_NaN());
  parallel_for(out.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (labels.label[v] != garment.layer) continue;
      const ClosestHit hit = cloth.closest(scan.mesh.positions[v]);
      if (!hit.found()) continue;
      const double outside = (scan.mesh.positions[v] - hit.point).dot(hit.normal);
      out[v] = static_cast<float>(std::copysign(std::sqrt(hit.squared_distance), outside));
    }
  });
  return out;
}

void take(Stage& stage, const std::vector<std::uint8_t>& cloth,
          const std::vector<std::uint8_t>& caps, GarmentAnalysis& out) {
  for (std::size_t s = 0; s < cloth.size(); ++s)
    if (cloth[s]) stage.taken[s] = 1;
  for (std::size_t f = 0; f < caps.size(); ++f) stage.cap[f] = stage.cap[f] != 0 || caps[f] != 0;
  out.vertices_labelled = static_cast<std::size_t>(std::count(
      stage.labels.label.begin(), stage.labels.label.end(), static_cast<std::uint8_t>(out.layer)));
}

std::string centimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f cm", 100 * metres);
  return text;
}

namespace {

constexpr double kWorthSaying = 0.1;  // weight of a rival that a person should hear of

/// Edges that may as well lie elsewhere, and how to say where.
void warn_of_rivals(const GarmentTemplate& garment, const std::vector<EdgeCurve>& edges,
                    std::vector<std::string>& warnings) {
  for (const EdgeCurve& edge : edges) {
    const double height = mean_height(edge.points);
    for (const EdgeRival& rival : edge.rivals) {
      if (rival.weight < kWorthSaying) continue;
      char text[200];
      std::snprintf(text, sizeof text,
                    " may as well lie %.1f cm %s (weight %.2f); if so, give --hint %s.%s_edge=%.1f",
                    100 * std::abs(rival.height - height),
                    rival.height < height ? "lower" : "higher", rival.weight,
                    garment.name().c_str(), edge.name.c_str(), 100 * rival.height);
      warnings.push_back(garment.title() + ": its " + edge.name + text);
    }
  }
}

}  // namespace

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
  warn_of_rivals(garment, found.edges, warnings);
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

}  // namespace regarment
