#include "measure/find_cuff.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kSaidReach = 0.03;    // m along the arm about the place that a person gave
constexpr double kSleeveRadius = 0.1;  // m, what lies further from an arm's axis is torso
constexpr int kCuffCandidates = 10;    // folds of a sleeve look like its edge
constexpr double kCuffStray = 0.015, kCuffTilt = 0.05;  // m, a cuff is cut straight
constexpr double kSleeveError = 0.007;                  // m, of a cuff that shows all the way round
constexpr double kLeastSlope = 0.34;  // sine of 20 degrees: 1 cm of height is 3 cm of a level arm
constexpr int kLeastShare = 2;        // of a row's cells one in so many must hold data

/// Mean height of a row of the arm's surface; nothing where too little of it shows.
std::optional<double> height_of(const LimbView& arm, int row) {
  double sum = 0;
  int shown = 0;
  for (int j = 0; j < arm.map.columns; ++j) {
    const double r = arm.map.radius[arm.map.index(row, j)];
    if (!arm.map.has(row, j) || r > kSleeveRadius) continue;
    sum += arm.axis.point({arm.map.row_s(row), arm.map.column_phi(j), r}).y();
    ++shown;
  }
  if (shown * kLeastShare < arm.map.columns) return std::nullopt;
  return sum / shown;
}

[[noreturn]] void refuse(const std::string& name, double height, const char* why) {
  char text[240];
  std::snprintf(text, sizeof text, "--hint: %.60s_edge=%.1f: %s", name.c_str(), 100 * height, why);
  throw UsageError(text);
}

/// Where on the arm its surface lies so high on the average.
double place_at_height(const LimbView& arm, const std::string& name, const ArmStretch& where,
                       double height) {
  double nearest = kSaidReach, s = 0;
  for (int i = 0; i < arm.map.rows; ++i) {
    const double at = arm.map.row_s(i);
    const std::optional<double> mean = height_of(arm, i);
    if (at < where.s_low || at > where.s_high || !mean || std::abs(*mean - height) >= nearest)
      continue;
    nearest = std::abs(*mean - height), s = at;
  }
  if (nearest >= kSaidReach)
    refuse(name, height, "the arm shows nothing at this height where a sleeve may end; look again");
  if (std::abs(arm.axis.tangent(s).y()) < kLeastSlope)
    refuse(name, height,
           "the arm is held too level there for a height to say where; give the sleeve's length "
           "by --fix");
  return s;
}

EdgeSearch search_of(const ArmStretch& where) {
  EdgeSearch search;
  search.garment_above = false;
  search.s_low = where.s_low, search.s_high = where.s_high;
  search.straightness = kCuffStray, search.tilt = kCuffTilt;
  search.widest = kSleeveRadius, search.least_error = kSleeveError;
  return search;
}

}  // namespace

std::optional<Cuff> find_cuff(const LimbView& arm, const std::string& name, const std::string& limb,
                              const ArmStretch& where, const std::optional<double>& said) {
  Cuff cuff{name, limb, arm.map.s_low, find_edges(arm.map, search_of(where), kCuffCandidates), {}};
  if (said) {
    const double s = place_at_height(arm, name, where, *said);
    std::vector<FoundEdge> there =
        find_edges(arm.map, search_of({s - kSaidReach, s + kSaidReach}), 1);
    if (there.empty())
      refuse(name, *said, "the arm shows no loop of cloth or skin at this height; look again");
    if (!cuff.places.empty()) cuff.clearest = std::move(cuff.places.front());
    cuff.places = std::move(there);
  }
  if (cuff.places.empty()) return std::nullopt;
  return cuff;
}

}  // namespace regarment
