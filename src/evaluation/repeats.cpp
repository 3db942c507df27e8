#include "evaluation/repeats.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "evaluation/group_statistics.h"
#include "evaluation/statistics.h"

namespace regarment {
namespace {

constexpr double kSameTruth = 0.01;  // cm

RepeatedDimension dimension_of(const EvaluatedScan& scan, const TrueDimension& truth) {
  RepeatedDimension out;
  out.garment = scan.about.garment;
  out.key = measurement_key(truth);
  out.name = measurement_name(truth);
  out.truth_cm = truth.truth_cm;
  return out;
}

void sum_up(RepeatedDimension& repeat) {
  std::vector<Sample> samples;
  for (const double error : repeat.errors_cm) samples.push_back({0, error, {}, {}});
  const ErrorStatistics errors = error_statistics(samples);
  repeat.mean_error_cm = errors.bias_cm;
  repeat.sd_cm = errors.sd_cm.value_or(0);
  const auto [low, high] = std::minmax_element(repeat.errors_cm.begin(), repeat.errors_cm.end());
  repeat.range_cm = *high - *low;
}

// What is added up for one measurement.
struct Sums {
  double squares = 0, freedom = 0, single = 0, pooled = 0;
  RepeatSummary out;

  void add(const RepeatedDimension& repeat) {
    const auto n = static_cast<double>(repeat.errors_cm.size());
    squares += (n - 1) * repeat.sd_cm * repeat.sd_cm;
    freedom += n - 1;
    for (const double error : repeat.errors_cm) single += std::abs(error);
    pooled += std::abs(repeat.mean_error_cm);
    ++out.garments;
    out.scans += repeat.errors_cm.size();
  }

  RepeatSummary summary() const {
    RepeatSummary made = out;
    made.within_sd_cm = std::sqrt(squares / freedom);
    made.single_mae_cm = single / static_cast<double>(out.scans);
    made.pooled_mae_cm = pooled / static_cast<double>(out.garments);
    return made;
  }
};

}  // namespace

std::vector<RepeatedDimension> repeated_dimensions(const std::vector<EvaluatedScan>& scans) {
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  std::vector<RepeatedDimension> all;
  for (const EvaluatedScan& scan : scans) {
    if (scan.about.garment.empty()) continue;
    for (std::size_t d = 0; d < scan.found.size(); ++d) {
      const TrueDimension& truth = scan.about.dimensions[d];
      if (!scan.found[d] || truth.hidden()) continue;
      const auto [place, is_new] =
          places.try_emplace({scan.about.garment, measurement_key(truth)}, all.size());
      if (is_new) all.push_back(dimension_of(scan, truth));
      RepeatedDimension& repeat = all[place->second];
      if (std::abs(repeat.truth_cm - truth.truth_cm) > kSameTruth) continue;
      repeat.scans.push_back(scan.about.name);
      repeat.errors_cm.push_back(scan.found[d]->value_cm - truth.truth_cm);
    }
  }
  std::erase_if(all, [](const RepeatedDimension& repeat) { return repeat.scans.size() < 2; });
  for (RepeatedDimension& repeat : all) sum_up(repeat);
  return all;
}

std::vector<RepeatSummary> repeat_summaries(const std::vector<RepeatedDimension>& repeats) {
  std::map<std::string, Sums> all;
  for (const RepeatedDimension& repeat : repeats) {
    Sums& sums = all[repeat.key];
    sums.out.key = repeat.key;
    sums.out.name = repeat.name;
    sums.add(repeat);
  }
  std::vector<RepeatSummary> out;
  out.reserve(all.size());
  for (const auto& [key, sums] : all) out.push_back(sums.summary());
  return out;
}

}  // namespace regarment
