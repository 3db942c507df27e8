#include "report/checks.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "report/judgement.h"
#include "report/text.h"

namespace regarment {
namespace {

// From where on a light is no longer good, and from where on it is poor. Set by judgement; the page
// shows them.
struct Limits {
  double good = 0, poor = 0;

  CheckLevel up_to(double value) const {
    if (value <= good) return CheckLevel::Good;
    return value <= poor ? CheckLevel::Look : CheckLevel::Poor;
  }
  CheckLevel from(double value) const {
    if (value >= good) return CheckLevel::Good;
    return value >= poor ? CheckLevel::Look : CheckLevel::Poor;
  }
};

constexpr Limits kHalfInterval = {1.5, 3.0};  // cm, median over the dimensions seen
constexpr Limits kDistance = {kDeviationBand, 2.0 * kDeviationBand};  // mm, 95 % of the scan
constexpr Limits kStretch = {3.0, 8.0};                               // %, either way
constexpr Limits kEdgeSeen = {80.0, 50.0};                            // % of the least seen edge
constexpr Limits kLabelsSure = {95.0, 85.0};                          // %
constexpr Limits kLabelOverlap = {0.97, 0.9};                         // mean IoU

std::string up_to_text(const Limits& limits, const std::string& unit) {
  return "Good up to " + short_text(limits.good) + unit + ", poor beyond " +
         short_text(limits.poor) + unit + ".";
}

std::string from_text(const Limits& limits, const std::string& unit) {
  return "Good from " + short_text(limits.good) + unit + " on, poor below " +
         short_text(limits.poor) + unit + ".";
}

std::string of(std::size_t part, std::size_t whole) {
  return std::to_string(part) + " of " + std::to_string(whole);
}

// Rounded down, so that 100 % means all.
std::string percent_text(double percent) {
  return fixed_text(std::floor(percent * 10.0) / 10.0, 1) + "\u202f%";
}

void keep(std::vector<Check>& checks, Check check) {
  if (check.level == CheckLevel::Good) check.advice.clear();
  checks.push_back(std::move(check));
}

std::vector<const ResultMeasurement*> all_measurements(const Result& result) {
  std::vector<const ResultMeasurement*> out;
  for (const ResultGarment& garment : result.garments) {
    for (const ResultMeasurement& m : garment.measurements) out.push_back(&m);
  }
  return out;
}

void check_measured(const Result& result, std::vector<Check>& checks) {
  const auto all = all_measurements(result);
  const auto seen = static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const auto* m) { return m->observable; }));
  Check check;
  check.name = "Dimensions measured";
  check.found = of(seen, all.size());
  check.threshold = "Good when the scan shows all, poor when it shows less than half.";
  check.advice =
      "What the scan does not show is in brackets and is a probable value. Scan without "
      "what covers it, or give what is known with --fix NAME=CM.";
  check.place = "garment-1";
  if (seen < all.size()) {
    check.level = 2 * seen < all.size() ? CheckLevel::Poor : CheckLevel::Look;
  }
  keep(checks, check);
}

void check_certainty(const Result& result, std::vector<Check>& checks) {
  std::vector<double> half;
  for (const ResultMeasurement* m : all_measurements(result)) {
    if (m->observable && !m->fixed) half.push_back((m->high_cm - m->low_cm) / 2.0);
  }
  if (half.empty()) return;
  const double middle = median(half);
  Check check;
  check.level = kHalfInterval.up_to(middle);
  check.name = "Certainty";
  check.found = "half of the dimensions to \u00b1" + fixed_text(middle, 1) + "\u202fcm";
  check.threshold = up_to_text(kHalfInterval, "\u202fcm");
  check.advice =
      "Say what is known: --fabric narrows tight places, --fix NAME=CM holds a dimension, --hint "
      "NAME_edge=CM settles where an edge lies.";
  check.place = "garment-1";
  keep(checks, check);
}

void check_specification(const Result& result, std::vector<Check>& checks) {
  std::size_t passed = 0, unsure = 0, failed = 0;
  for (const ResultMeasurement* m : all_measurements(result)) {
    const Judgement judgement = judge(*m);
    passed += judgement == Judgement::Pass || judgement == Judgement::LikelyPass;
    unsure += judgement == Judgement::LikelyFail;
    failed += judgement == Judgement::Fail;
  }
  const std::size_t judged = passed + unsure + failed;
  if (judged == 0) return;
  Check check;
  check.name = "Against the specification";
  check.found = of(passed, judged) + " within tolerance";
  check.threshold = "Good when all are, poor when one is outside with its whole interval.";
  check.advice = "The column Result says which lines fail.";
  check.place = "garment-1";
  if (unsure > 0) check.level = CheckLevel::Look;
  if (failed > 0) check.level = CheckLevel::Poor;
  keep(checks, check);
}

void check_distance(const ResultGarment& garment, const std::string& place,
                    std::vector<Check>& checks) {
  if (!garment.deviation) return;
  Check check;
  check.level = kDistance.up_to(garment.deviation->p95_mm);
  check.name = garment.title + " on the scan";
  check.found =
      "95\u202f% of its scan within " + fixed_text(garment.deviation->p95_mm, 1) + "\u202fmm of it";
  check.threshold = up_to_text(kDistance, "\u202fmm");
  check.advice = "Look where the deviation is large: folds, a hole, or another kind of garment.";
  check.place = place;
  keep(checks, check);
}

void check_stretch(const ResultGarment& garment, const std::string& place,
                   std::vector<Check>& checks) {
  const double percent = std::abs(garment.mean_stretch - 1.0) * 100.0;
  Check check;
  check.level = kStretch.up_to(percent);
  check.name = garment.title + "'s cloth";
  check.found = fixed_text(percent, 1) + "\u202f% " +
                (garment.mean_stretch < 1.0 ? "compressed" : "stretched") + " on average";
  check.threshold = up_to_text(kStretch, "\u202f%");
  check.advice =
      "Cloth at rest keeps its lengths: the dimensions found may be too small (stretched) or too "
      "large (compressed).";
  check.place = place;
  keep(checks, check);
}

std::string words_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

void check_edges(const ResultGarment& garment, const std::string& place,
                 std::vector<Check>& checks) {
  if (garment.edges.empty()) return;
  const auto least = std::min_element(
      garment.edges.begin(), garment.edges.end(),
      [](const ResultEdge& a, const ResultEdge& b) { return a.coverage < b.coverage; });
  const bool rivals = std::any_of(garment.edges.begin(), garment.edges.end(),
                                  [](const ResultEdge& e) { return !e.rivals.empty(); });
  Check check;
  check.level = kEdgeSeen.from(least->coverage * 100.0);
  check.name = garment.title + "'s edges";
  check.found = words_of(least->name) + " seen to " + percent_text(least->coverage * 100.0) +
                (garment.edges.size() > 1 ? ", others further" : "");
  if (rivals) {
    check.level = std::max(check.level, CheckLevel::Look);
    check.found += "; one may lie elsewhere";
  }
  check.threshold = from_text(kEdgeSeen, "\u202f%") + " An edge with two places needs a look.";
  check.advice = "See the edges found; --hint NAME_edge=CM says at which height one lies.";
  check.place = place;
  keep(checks, check);
}

void check_search(const ResultGarment& garment, std::size_t number, std::vector<Check>& checks) {
  if (!garment.search) return;
  const auto& runs = garment.search->runs;
  const auto converged = static_cast<std::size_t>(std::count_if(
      runs.begin(), runs.end(), [](const auto& r) { return r.ending == FitEnding::Converged; }));
  Check check;
  check.name = garment.title + "'s search";
  check.found = of(converged, runs.size()) + " runs converged";
  check.threshold = "Good when the kept run did, else poor.";
  check.advice = "Search again with more --runs or another --seed.";
  check.place = "search-" + std::to_string(number);
  if (runs[garment.search->kept - 1].ending != FitEnding::Converged) check.level = CheckLevel::Poor;
  keep(checks, check);
}

void check_labels(const Result& result, std::vector<Check>& checks) {
  const double vertices = static_cast<double>(std::max<std::size_t>(1, result.scan.vertices));
  const double sure = 100.0 * (1.0 - static_cast<double>(result.unsure) / vertices);
  Check check;
  check.level = kLabelsSure.from(sure);
  check.name = "Labels";
  check.found = percent_text(sure) + " of the vertices are sure";
  check.threshold = from_text(kLabelsSure, "\u202f%");
  check.advice = "Look at the segmentation along its borders.";
  check.place = "labels";
  keep(checks, check);
  if (!result.label_score) return;
  check.level = kLabelOverlap.from(result.label_score->mean_iou);
  check.name = "Labels against true ones";
  check.found = "mean overlap (IoU) " + fixed_text(result.label_score->mean_iou, 3);
  check.threshold = from_text(kLabelOverlap, "");
  check.advice = "See which label overlaps least.";
  keep(checks, check);
}

void check_scan(const Result& result, std::vector<Check>& checks) {
  Check check;
  std::size_t remarks = 0;
  for (const Finding& finding : result.scan.findings) {
    if (finding.severity == Severity::Note) continue;
    ++remarks;
    const bool problem = finding.severity == Severity::Problem;
    check.level = std::max(check.level, problem ? CheckLevel::Poor : CheckLevel::Look);
  }
  check.name = "Scan";
  check.found = remarks == 0 ? "nothing stands out"
                             : counted(remarks, "finding needs a look", "findings need a look");
  check.threshold = "Good with notes at most, poor with a problem.";
  check.advice = "What was found stands under Scan, with advice.";
  check.place = "scan";
  keep(checks, check);
}

}  // namespace

std::vector<Check> checks_of(const Result& result) {
  std::vector<Check> checks;
  check_measured(result, checks);
  check_certainty(result, checks);
  check_specification(result, checks);
  for (std::size_t i = 0; i < result.garments.size(); ++i) {
    const ResultGarment& garment = result.garments[i];
    const std::string place = "garment-" + std::to_string(i + 1);
    check_distance(garment, result.figures.empty() ? place : "pictures", checks);
    check_stretch(garment, place, checks);
    check_edges(garment, place, checks);
    check_search(garment, i + 1, checks);
  }
  check_labels(result, checks);
  check_scan(result, checks);
  return checks;
}

CheckLevel worst_level(const std::vector<Check>& checks) {
  CheckLevel worst = CheckLevel::Good;
  for (const Check& check : checks) worst = std::max(worst, check.level);
  return worst;
}

}  // namespace regarment
