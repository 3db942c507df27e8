#pragma once

#include <map>
#include <string>
#include <vector>

#include "measure/garment_edges.h"

namespace regarment {

/// How probable a place of an edge is that shows so much less evidence (mean over the loop) than
/// another, over how probable that one is; above 1 when it shows more.
double probability_ratio(double less_evidence);

/// Evidence that the cuffs of two sleeves lose which end `apart` m differently far from where the
/// maps of their arms begin: sleeves of one garment end alike.
double lost_by_unequal_sleeves(double apart);

/// Makes one of the places, in any order, the edge and those that are nearly as probable its
/// rivals; `score` tells how probable they are.
void settle(std::vector<FoundEdge> places, std::size_t chosen, double FoundEdge::*score,
            GarmentEdge& edge);

/// Where a sleeve may end.
struct Cuff {
  std::string name, limb;
  double map_low = 0;             // m, where the map of its arm begins: a fixed place on the arm
  std::vector<FoundEdge> places;  // in order of `score`, at least one
  std::optional<FoundEdge> clearest;  // the place of most evidence, where it is none of these

  double along(std::size_t i) const { return places[i].mean_s() - map_low; }
};

/// Of the places where cuffs may be, those of most evidence all the way round; where there are two
/// sleeves, they end alike. By name.
std::map<std::string, GarmentEdge> settled_cuffs(std::vector<Cuff> cuffs);

}  // namespace regarment
