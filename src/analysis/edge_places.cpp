#include "analysis/edge_places.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "measure/edge_choice.h"

namespace regarment {
namespace {

/// Which of its places an edge takes: 0 as found, i its rival i - 1.
struct Move {
  std::string name;
  std::size_t place = 0;
};

struct Choice {
  std::vector<Move> moves;
  double weight = 0;
};

double weight_at(const GarmentEdge& edge, std::size_t place) {
  if (place > 0) return edge.rivals[place - 1].weight;
  double rest = 1;
  for (const EdgeHypothesis& rival : edge.rivals) rest -= rival.weight;
  return rest;
}

/// m from the beginning of the limb's map, a fixed place on an arm, to the edge.
double along(const GarmentEdges& edges, const GarmentEdge& edge, std::size_t place) {
  const FoundEdge& found = place > 0 ? edge.rivals[place - 1].edge : edge.found;
  return found.mean_s() - edges.limbs.at(edge.limb).map.s_low;
}

/// All places of two cuffs, but for both as found.
void add_cuffs(const GarmentEdges& edges, const std::string& left, const std::string& right,
               std::vector<Choice>& out) {
  const GarmentEdge &l = edges.edges.at(left), &r = edges.edges.at(right);
  const auto lost = [&](std::size_t a, std::size_t b) {
    return lost_by_unequal_sleeves(along(edges, l, a) - along(edges, r, b));
  };
  const double as_found = weight_at(l, 0) * weight_at(r, 0);
  for (std::size_t a = 0; a <= l.rivals.size(); ++a)
    for (std::size_t b = 0; b <= r.rivals.size(); ++b) {
      if (a + b == 0) continue;
      const double alike = probability_ratio(lost(a, b) - lost(0, 0));
      // What the finder chose has reasons of its own: nothing is more probable than it.
      const double weight = std::min(1.0, weight_at(l, a) * weight_at(r, b) / as_found * alike);
      out.push_back({{{left, a}, {right, b}}, weight});
    }
}

std::vector<Choice> choices(const GarmentEdges& edges) {
  std::vector<Choice> out;
  std::vector<std::string> cuffs;
  for (const auto& [name, edge] : edges.edges) {
    if (edge.covered) continue;
    if (edge.limb == "left_arm" || edge.limb == "right_arm") cuffs.push_back(name);
  }
  const bool both = cuffs.size() == 2;
  if (both) add_cuffs(edges, cuffs[0], cuffs[1], out);
  for (const auto& [name, edge] : edges.edges) {
    if (edge.covered || (both && (name == cuffs[0] || name == cuffs[1]))) continue;
    for (std::size_t i = 1; i <= edge.rivals.size(); ++i)
      out.push_back({{{name, i}}, weight_at(edge, i) / weight_at(edge, 0)});
  }
  return out;
}

EdgePlaces moved_to(const GarmentEdges& edges, const Choice& choice) {
  EdgePlaces out{edges, {}, choice.weight};
  for (const Move& move : choice.moves) {
    if (move.place == 0) continue;
    GarmentEdge& edge = out.edges.edges.at(move.name);
    EdgeHypothesis& rival = edge.rivals[move.place - 1];
    rival.weight = weight_at(edge, 0);
    std::swap(rival.edge, edge.found);
    std::stable_sort(
        edge.rivals.begin(), edge.rivals.end(),
        [](const EdgeHypothesis& a, const EdgeHypothesis& b) { return a.weight > b.weight; });
    out.moved.push_back(move.name);
  }
  return out;
}

}  // namespace

std::vector<EdgePlaces> edge_places(const GarmentEdges& edges, std::size_t most, double least) {
  std::vector<Choice> others = choices(edges);
  std::stable_sort(others.begin(), others.end(),
                   [](const Choice& a, const Choice& b) { return a.weight > b.weight; });
  if (others.size() > most) others.resize(most);
  const auto total = [&] {
    return std::accumulate(others.begin(), others.end(), 1.0,
                           [](double sum, const Choice& c) { return sum + c.weight; });
  };
  while (!others.empty() && others.back().weight < least * total()) others.pop_back();
  std::vector<EdgePlaces> out{{edges, {}, 1 / total()}};
  for (const Choice& choice : others) {
    out.push_back(moved_to(edges, choice));
    out.back().weight /= total();
  }
  return out;
}

}  // namespace regarment
