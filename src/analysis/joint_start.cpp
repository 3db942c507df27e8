#include "analysis/joint_start.h"

#include <optional>
#include <utility>

#include "analysis/edge_places.h"
#include "analysis/joint_target.h"
#include "base/error.h"
#include "garment/hold_dimensions.h"
#include "geometry/parallel.h"
#include "measure/lay_on_scan.h"

namespace regarment {
namespace {

// The energy counts the scan's errors as if neighbours erred alone; lengths measured on it know
// better how far they may be off.
constexpr double kLengthTrust = 0.25;
constexpr std::size_t kMostPlaces = 3;  // beside the edges as found
constexpr double kLeastWeight = 0.1;    // of a place that is worth a fit

/// What was measured on the scan holds the fit where folds could be taken for more cloth.
std::vector<MeasuredLength> lengths_of(const std::vector<ObservedLength>& observed,
                                       const std::map<std::string, HiddenEdge>& hidden) {
  std::vector<MeasuredLength> out;
  for (const ObservedLength& o : observed) {
    if (o.seen)
      out.push_back({o.observation->equals, o.value, kLengthTrust * o.standard_deviation});
    else if (const auto length = probable_length(o, hidden))
      out.push_back({o.observation->equals, length->value, length->standard_deviation});
  }
  return out;
}

JointOptions options_of(const GarmentTemplate& garment, const Stage& stage) {
  JointOptions options = stage.options.joint;
  options.fixed = fixed_of(stage.options, garment);
  return options;
}

/// The garment laid on the scan at the dimensions measured there, and fitted coarsely.
JointStart start_from(SeenGarment seen, const GarmentTemplate& garment, Pattern pattern,
                      const Stage& stage, const Progress& progress) {
  JointStart out;
  JointOptions options = options_of(garment, stage);
  out.solved = solve_dimensions(garment, seen.observed, options.fixed);
  Dimensions at;
  for (const Dimension& d : garment.dimensions()) at[d.name] = out.solved.at(d.name).value;
  out.hidden = hidden_edges(seen.edges, stage.body);
  for (const ObservedLength& o : seen.observed)
    if (const auto length = probable_length(o, out.hidden);
        length && at.contains(o.observation->equals))
      at[o.observation->equals] = length->value;
  at = nearest_holding(garment, at, options.fixed);
  move_pattern(garment, at, pattern);
  std::map<std::string, std::vector<Vec3>> curves;
  for (const EdgeCurve& e : edge_curves(seen.edges))
    if (e.evidence != "covered") curves[e.name] = e.points;
  const std::vector<Vec3> placed = place_garment(pattern, placement_target(seen.edges, pattern));
  std::vector<Vec3> laid;
  run_together(
      {[&] { laid = lay_on_scan(pattern, placed, stage.samples, seen.cloth, curves); },
       [&] { out.target = joint_target(stage.samples, seen.cloth, seen.edges, out.hidden); }});
  out.target.outer = stage.outer;
  out.lengths = lengths_of(seen.observed, out.hidden);
  options.levels.resize(1);
  out.coarse = joint_fit(garment, at, pattern, laid, out.target, out.lengths, options, progress);
  out.seen = std::move(seen);
  return out;
}

}  // namespace

std::vector<JointStart> joint_starts(const GarmentTemplate& garment, int layer, const Stage& stage,
                                     const Progress& progress) {
  const Pattern pattern =
      make_pattern(garment, garment.typical(), stage.options.pattern_edge_length);
  SeenGarment seen = look_for(garment, pattern, layer, stage);
  std::vector<EdgePlaces> places = edge_places(seen.edges, kMostPlaces, kLeastWeight);
  std::vector<std::optional<JointStart>> made(places.size());
  const auto make = [&](std::size_t i) {
    if (i == 0) {
      made[0] = start_from(std::move(seen), garment, pattern, stage, progress);
      return;
    }
    try {
      SeenGarment other = look_between(std::move(places[i].edges), garment, stage);
      made[i] = start_from(std::move(other), garment, pattern, stage, {});
    } catch (const NoGarmentError&) {
      made[i].reset();  // no garment can lie there: the place is none
    } catch (const InvalidInput&) {
      made[i].reset();  // its edges make no shape to start from
    }
  };
  parallel_for(places.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) make(i);
  });
  std::vector<JointStart> out;
  double sum = 0;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (!made[i]) continue;
    out.push_back(std::move(*made[i]));
    out.back().moved = std::move(places[i].moved);
    out.back().weight = places[i].weight;
    sum += out.back().weight;
  }
  for (JointStart& start : out) start.weight /= sum;
  return out;
}

JointFit finish_joint_fit(const GarmentTemplate& garment, const JointStart& start,
                          const Stage& stage, const Progress& progress) {
  JointOptions options = options_of(garment, stage);
  if (options.levels.size() < 2) return start.coarse;
  options.levels.erase(options.levels.begin());
  const JointFit& coarse = start.coarse;
  return joint_fit(garment, coarse.dimensions, coarse.pattern, coarse.draped, start.target,
                   start.lengths, options, progress);
}

}  // namespace regarment
