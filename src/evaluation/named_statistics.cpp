#include "evaluation/named_statistics.h"

#include <cmath>

namespace regarment {
namespace {

using Value = std::optional<double>;
using Group = GroupStatistics;

constexpr double kAlike = 0.0005;  // half of the last digit that is stored

Value number(std::size_t count) { return static_cast<double>(count); }

// What has no meaning without samples.
Value of(const ErrorStatistics& errors, double value) {
  return errors.n == 0 ? Value() : Value(value);
}

// How far from what it should be; the smaller the better.
double badness(Better better, double value) {
  switch (better) {
    case Better::Neither:
      return 0;
    case Better::Smaller:
      return value;
    case Better::Larger:
      return -value;
    case Better::NearZero:
      return std::abs(value);
    case Better::NearOne:
      return std::abs(value - 1);
    case Better::NearNinety:
      return std::abs(value - 0.9);
  }
  return 0;
}

}  // namespace

const std::vector<NamedStatistic>& named_statistics() {
  static const std::vector<NamedStatistic> all = {
      {"scans", Better::Neither, [](const Group& g) { return number(g.scans); }},
      {"failures", Better::Smaller, [](const Group& g) { return number(g.failures); }},
      {"n", Better::Neither, [](const Group& g) { return number(g.errors.n); }},
      {"bias_cm", Better::NearZero, [](const Group& g) { return of(g.errors, g.errors.bias_cm); }},
      {"mae_cm", Better::Smaller, [](const Group& g) { return of(g.errors, g.errors.mae_cm); }},
      {"rmse_cm", Better::Smaller, [](const Group& g) { return of(g.errors, g.errors.rmse_cm); }},
      {"sd_cm", Better::Smaller, [](const Group& g) { return g.errors.sd_cm; }},
      {"median_cm", Better::NearZero,
       [](const Group& g) { return of(g.errors, g.errors.median_cm); }},
      {"p95_cm", Better::Smaller, [](const Group& g) { return of(g.errors, g.errors.p95_cm); }},
      {"worst_cm", Better::Smaller, [](const Group& g) { return of(g.errors, g.errors.worst_cm); }},
      {"slope", Better::NearOne, [](const Group& g) { return g.errors.slope; }},
      {"bias_low_cm", Better::Neither, [](const Group& g) { return g.errors.bias_low_cm; }},
      {"bias_high_cm", Better::Neither, [](const Group& g) { return g.errors.bias_high_cm; }},
      {"iso_limit_cm", Better::Neither,
       [](const Group& g) { return g.iso ? Value(g.iso->limit_cm) : Value(); }},
      {"iso_within", Better::Larger,
       [](const Group& g) { return g.iso ? Value(g.iso->within ? 1 : 0) : Value(); }},
      {"within_1cm", Better::Larger,
       [](const Group& g) { return of(g.errors, g.errors.within_1cm); }},
      {"within_2cm", Better::Larger,
       [](const Group& g) { return of(g.errors, g.errors.within_2cm); }},
      {"in_tolerance", Better::Larger,
       [](const Group& g) {
         return of(g.errors, static_cast<double>(g.in_tolerance) / static_cast<double>(g.errors.n));
       }},
      {"intervals", Better::Neither, [](const Group& g) { return number(g.errors.intervals); }},
      {"coverage", Better::NearNinety, [](const Group& g) { return g.errors.coverage; }},
      {"median_width_cm", Better::Smaller, [](const Group& g) { return g.errors.median_width_cm; }},
      {"interval_score_cm", Better::Smaller,
       [](const Group& g) { return g.errors.interval_score_cm; }},
      {"hidden", Better::Neither, [](const Group& g) { return number(g.hidden); }},
      {"hidden_flagged", Better::Larger, [](const Group& g) { return number(g.hidden_flagged); }},
      {"visible", Better::Neither, [](const Group& g) { return number(g.visible); }},
      {"visible_flagged", Better::Smaller,
       [](const Group& g) { return number(g.visible_flagged); }},
      {"confident", Better::Neither, [](const Group& g) { return number(g.confident); }},
      {"confident_wrong", Better::Smaller,
       [](const Group& g) { return number(g.confident_wrong); }},
      {"worn_n", Better::Neither, [](const Group& g) { return number(g.worn.n); }},
      {"worn_bias_cm", Better::NearZero, [](const Group& g) { return of(g.worn, g.worn.bias_cm); }},
      {"worn_mae_cm", Better::Smaller, [](const Group& g) { return of(g.worn, g.worn.mae_cm); }},
      {"published_n", Better::Neither, [](const Group& g) { return number(g.published.n); }},
      {"published_bias_cm", Better::Neither,
       [](const Group& g) { return of(g.published, g.published.bias_cm); }},
      {"published_mae_cm", Better::Neither,
       [](const Group& g) { return of(g.published, g.published.mae_cm); }},
      {"frames", Better::Neither, [](const Group& g) { return number(g.frames); }},
      {"frames_wrong", Better::Smaller, [](const Group& g) { return number(g.frames_wrong); }},
      {"labelled", Better::Neither, [](const Group& g) { return number(g.labelled); }},
      {"miou", Better::Larger, [](const Group& g) { return g.miou; }},
      {"border_mm", Better::Smaller, [](const Group& g) { return g.border_mm; }},
      {"seconds_median", Better::Neither, [](const Group& g) { return g.seconds_median; }},
      {"seconds_p95", Better::Neither, [](const Group& g) { return g.seconds_p95; }},
  };
  return all;
}

std::string full_name(const GroupStatistics& group, std::string_view statistic) {
  return group.key.empty() ? std::string(statistic) : group.key + "." + std::string(statistic);
}

int compare(Better better, double before, double now) {
  const double change = badness(better, now) - badness(better, before);
  if (std::abs(change) < kAlike) return 0;
  return change < 0 ? 1 : -1;
}

}  // namespace regarment
