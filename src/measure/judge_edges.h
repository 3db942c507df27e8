#pragma once

#include <map>
#include <string>

#include "measure/garment_edges.h"

namespace regarment {

/// Do the edges found prove that the garment is worn? A body's own shape shows edges, too: a crotch
/// looks like a hem, an elbow like a cuff. One edge beyond doubt makes up for another that is
/// faint. Edges whose heights a person gave (`said`) and covered ones prove nothing and need not
/// show. Throws NoGarmentError naming the garment by `title`, with the evidence, when they do not.
void judge_edges(const GarmentEdges& edges, const Body& body, const std::string& title,
                 const std::map<std::string, double>& said);

}  // namespace regarment
