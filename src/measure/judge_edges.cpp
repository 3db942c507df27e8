#include "measure/judge_edges.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kLeastCoverage = 0.8;  // of the loop where a person's own shape shows no edge
constexpr double kLeastScore = 0.8;
constexpr double kSureCoverage = 0.93, kSureScore = 1.0;    // no body shows so much
constexpr double kStrongScore = 1.4, kLikelyScore = 0.85;   // where legs join: hem, cuffs
constexpr double kFaintCoverage = 0.6, kFaintScore = 0.65;  // what a sure edge elsewhere excuses
constexpr double kBesideOuter = 0.7;  // of evidence on the arms under a garment that is proven
constexpr double kOwnColour = 0.2;    // colour difference that cloth has to what lies below it
constexpr double kNoColour = 0.06;    // and that skin has to skin
constexpr double kForkBelow = 0.03, kForkAbove = 0.12;  // m, a hem or crotch about where legs join

bool shows(const FoundEdge& edge) {
  return edge.coverage >= kLeastCoverage && edge.score >= kLeastScore;
}

struct Judge {
  const GarmentEdges& edges;
  const Body& body;
  const std::string& title;
  const std::map<std::string, double>& said;

  bool at_fork(const FoundEdge& edge) const;
  bool open_on_torso(const std::string& name, const GarmentEdge& edge) const {
    return edge.limb == "torso" && !edge.covered && said.count(name) == 0;
  }
  bool hem_joins_legs() const;
  void skirt() const;
  void tshirt() const;
  [[noreturn]] void missing(const std::string& name, const FoundEdge& edge) const;
  [[noreturn]] void no_sleeves() const;
};

std::string describe(const std::string& name, const FoundEdge& edge) {
  char text[160];
  std::snprintf(
      text, sizeof text,
      "its %s shows on %.0f %% of the loop with %.0f %% of the evidence of a cloth's edge",
      name.c_str(), 100 * edge.coverage, 100 * std::max(0.0, edge.score));
  return edge.found() ? text : "no data where its " + name + " would be";
}

void Judge::missing(const std::string& name, const FoundEdge& edge) const {
  throw NoGarmentError("no " + title + " on this scan: " + describe(name, edge) +
                       "; ask for the garment that is worn");
}

void Judge::no_sleeves() const {
  throw NoGarmentError(
      "no " + title +
      " on this scan: neither sleeve shows an edge on the arm; ask for the garment that is worn");
}

bool Judge::at_fork(const FoundEdge& edge) const {
  const double mean =
      std::accumulate(edge.s.begin(), edge.s.end(), 0.0) / static_cast<double>(edge.s.size());
  return mean > body.fork - kForkBelow && mean < body.fork + kForkAbove;
}

/// Does the garment's hem hang where the legs begin, lower than any crotch? Nothing but a skirt
/// joins two legs there, so that a faint waist need not prove that one is worn.
bool Judge::hem_joins_legs() const {
  for (const auto& [name, edge] : edges.edges)
    if (edge.limb == "torso" && edge.garment_above && shows(edge.found) && at_fork(edge.found))
      return body.fork_is_garment;
  return false;
}

void Judge::skirt() const {
  if (hem_joins_legs()) return;
  for (const auto& [name, edge] : edges.edges)
    if (open_on_torso(name, edge) && !shows(edge.found)) missing(name, edge.found);
}

void Judge::tshirt() const {
  double best = 0, mean = 0, sleeves = 0, contrast = 0;
  bool shown = false;
  for (const auto& [name, edge] : edges.edges) {
    if (edge.limb == "torso" || edge.limb == "neck") continue;
    best = std::max(best, edge.found.score), contrast = std::max(contrast, edge.found.contrast);
    mean += edge.found.score, sleeves += 1;
    shown = shown || shows(edge.found);
  }
  mean /= std::max(1.0, sleeves);
  for (const auto& [name, edge] : edges.edges) {
    if (!open_on_torso(name, edge)) {
      if (edge.limb == "torso" && !shown && best < kBesideOuter) no_sleeves();
      continue;
    }
    const FoundEdge& hem = edge.found;
    // Cloth that has another colour than what lies below it ends in colour on the arms, too.
    if (sleeves > 0 && hem.contrast > kOwnColour && contrast < kNoColour) no_sleeves();
    const bool crotch = at_fork(hem);
    const bool sure = crotch ? hem.coverage >= kLeastCoverage && hem.score >= kStrongScore
                             : hem.coverage >= kSureCoverage && hem.score >= kSureScore;
    if (sure && (sleeves == 0 ? !crotch : best >= (crotch ? kLikelyScore : kFaintScore))) continue;
    // Noise makes cuffs of elbows and a hem of the crotch, but not much of either.
    if (shown && shows(hem) && (!crotch || best >= kSureScore || hem.score >= kSureScore)) continue;
    if (mean >= kSureScore && hem.coverage >= kFaintCoverage && hem.score >= kLeastScore && !crotch)
      continue;
    if (shows(hem)) no_sleeves();
    missing(name, hem);
  }
}

}  // namespace

void judge_edges(const GarmentEdges& edges, const Body& body, const std::string& title,
                 const std::map<std::string, double>& said) {
  const Judge judge{edges, body, title, said};
  for (const auto& [name, edge] : edges.edges)
    if (edge.limb == "torso" && !edge.found.found()) judge.missing(name, edge.found);
  if (edges.upper_body)
    judge.tshirt();
  else
    judge.skirt();
}

}  // namespace regarment
