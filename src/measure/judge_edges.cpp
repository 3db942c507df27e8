#include "measure/judge_edges.h"

#include <algorithm>
#include <cstdio>

#include "base/error.h"

namespace regarment {
namespace {

constexpr double kLeastCoverage = 0.8;  // of the loop where a person's own shape shows no edge
constexpr double kLeastScore = 0.8;
// Of T-shirts. Set on made people: no naked one without heavy noise shows a hem so clearly.
constexpr double kClearCoverage = 0.85, kClearScore = 1.0;
constexpr double kStrongScore = 1.4;  // where legs join
constexpr double kAnySleeve = 0.5;    // evidence of sleeves that a clear hem needs beside it
constexpr double kPlainScore = 0.95;  // of a hem beside a sleeve that shows
constexpr double kFaintCoverage = 0.6, kFaintScore = 0.8;  // what sleeves that show both excuse
constexpr double kBothSleeves = 0.95;                      // mean evidence of such sleeves
// An edge of cloth that hangs from the waist, on made people: wearers of T-shirts show less.
constexpr double kProvenSleeves = 1.4;  // mean evidence: whatever else there is, this is worn
constexpr double kSamePlace = 0.06;     // m, the hem and that edge are one
constexpr double kHemLead = 0.03;       // more evidence, as a hem, than as a top edge
constexpr double kWellAbove = 0.15;     // m, below it is the hem's own cloth
constexpr double kTopCoverage = 0.7, kTopScore = 0.58;
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
  bool hangs_from_waist(const FoundEdge& hem) const;
  void skirt() const;
  void tshirt() const;
  [[noreturn]] void missing(const std::string& name, const FoundEdge& edge) const;
  [[noreturn]] void no_sleeves() const;
  [[noreturn]] void other_garment() const;
};

/// What the arms show of sleeves.
struct Sleeves {
  int count = 0;
  bool shown = false;
  double best = 0, mean = 0;  // evidence
  double contrast = 0;        // largest

  explicit Sleeves(const GarmentEdges& edges) {
    for (const auto& [name, edge] : edges.edges) {
      if (edge.limb == "torso" || edge.limb == "neck") continue;
      // What a sleeve's folds show proves it as well as its edge does.
      const FoundEdge& clear = edge.clearest ? *edge.clearest : edge.found;
      best = std::max(best, clear.score), contrast = std::max(contrast, clear.contrast);
      mean += clear.score, count += 1;
      shown = shown || shows(clear);
    }
    mean /= std::max(1, count);
  }
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

void Judge::other_garment() const {
  char height[32];
  std::snprintf(height, sizeof height, "%.0f cm", 100 * edges.top_of_other.mean_s());
  throw NoGarmentError("no " + title + " on this scan: " + height +
                       " above the floor it shows the top edge of something that hangs from the "
                       "waist; ask for the garment that is worn");
}

bool Judge::at_fork(const FoundEdge& edge) const {
  const double mean = edge.mean_s();
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

/// Is what ends at this hem a skirt, or the skin above one? Where the hem and a top edge are the
/// same place, the side that lies higher is the cloth: each of them fits one side better.
bool Judge::hangs_from_waist(const FoundEdge& hem) const {
  const FoundEdge& top = edges.top_of_other;
  if (!top.found()) return false;
  const double above = top.mean_s() - hem.mean_s();
  if (std::abs(above) < kSamePlace) return hem.score < top.score + kHemLead;
  return (above < 0 || above > kWellAbove) && top.score >= kTopScore &&
         top.coverage >= kTopCoverage;
}

void Judge::tshirt() const {
  const Sleeves sleeves(edges);
  for (const auto& [name, edge] : edges.edges) {
    if (!open_on_torso(name, edge)) {
      if (edge.limb == "torso" && !sleeves.shown && sleeves.best < kBesideOuter) no_sleeves();
      continue;
    }
    const FoundEdge& hem = edge.found;
    // Cloth that has another colour than what lies below it ends in colour on the arms, too.
    if (sleeves.count > 0 && hem.contrast > kOwnColour && sleeves.contrast < kNoColour)
      no_sleeves();
    if (sleeves.mean < kProvenSleeves && hangs_from_waist(hem)) other_garment();
    const bool crotch = at_fork(hem) && !body.fork_is_garment;
    if (hem.coverage >= kClearCoverage && hem.score >= (crotch ? kStrongScore : kClearScore) &&
        (sleeves.count == 0 || sleeves.best >= kAnySleeve))
      continue;
    // Noise makes cuffs of elbows and a hem of the crotch, but not much of either.
    const double plain = crotch ? kClearScore : kPlainScore;
    if (sleeves.shown && shows(hem) && (hem.score >= plain || sleeves.best >= kClearScore))
      continue;
    if (sleeves.mean >= kBothSleeves && hem.coverage >= kFaintCoverage &&
        hem.score >= kFaintScore && !crotch)
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
