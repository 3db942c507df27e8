#include "measure/edge_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace regarment {
namespace {

constexpr double kSureness = 12;  // a place with less evidence is exp(-12 times it) as probable
constexpr double kLeastWeight = 0.05;    // of that of the best: less probable ones are not said
constexpr double kSleevesDiffer = 0.04;  // m, both sleeves end alike within this
constexpr double kUnequal = 0.1, kUnequalMost = 0.4;  // evidence lost at that difference, at most

std::vector<std::size_t> chosen_places(const std::vector<Cuff>& cuffs) {
  std::vector<std::size_t> chosen;
  for (const Cuff& cuff : cuffs) {
    const auto most = std::max_element(
        cuff.places.begin(), cuff.places.end(),
        [](const FoundEdge& a, const FoundEdge& b) { return a.even_score < b.even_score; });
    chosen.push_back(static_cast<std::size_t>(most - cuff.places.begin()));
  }
  if (cuffs.size() != 2) return chosen;
  double best = -1e9;
  for (std::size_t a = 0; a < cuffs[0].places.size(); ++a)
    for (std::size_t b = 0; b < cuffs[1].places.size(); ++b) {
      const double sum = cuffs[0].places[a].even_score + cuffs[1].places[b].even_score -
                         lost_by_unequal_sleeves(cuffs[0].along(a) - cuffs[1].along(b));
      if (sum > best) best = sum, chosen = {a, b};
    }
  return chosen;
}

}  // namespace

double probability_ratio(double less_evidence) { return std::exp(-kSureness * less_evidence); }

double lost_by_unequal_sleeves(double apart) {
  const double share = apart / kSleevesDiffer;
  return std::min(kUnequalMost, kUnequal * share * share);
}

void settle(std::vector<FoundEdge> places, std::size_t chosen, double FoundEdge::*score,
            GarmentEdge& edge) {
  const double best = places[chosen].*score;
  double sum = 1;
  std::vector<EdgeHypothesis> rivals;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == chosen) continue;
    // What was not chosen although it shows more has reasons against it: as good as the chosen one.
    const double weight = probability_ratio(std::max(0.0, best - places[i].*score));
    if (weight < kLeastWeight) continue;
    rivals.push_back({std::move(places[i]), weight});
    sum += weight;
  }
  for (EdgeHypothesis& rival : rivals) rival.weight /= sum;
  edge.found = std::move(places[chosen]);
  edge.rivals = std::move(rivals);
}

std::map<std::string, GarmentEdge> settled_cuffs(std::vector<Cuff> cuffs) {
  const std::vector<std::size_t> chosen = chosen_places(cuffs);
  std::map<std::string, GarmentEdge> out;
  for (std::size_t c = 0; c < cuffs.size(); ++c) {
    GarmentEdge& edge = out[cuffs[c].name];
    edge.limb = cuffs[c].limb;
    edge.garment_above = false;
    // Places come in order of their score.
    edge.clearest = std::move(cuffs[c].clearest);
    if (chosen[c] != 0) edge.clearest = cuffs[c].places.front();
    settle(std::move(cuffs[c].places), chosen[c], &FoundEdge::even_score, edge);
  }
  return out;
}

}  // namespace regarment
