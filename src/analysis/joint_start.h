#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "analysis/hidden_edges.h"
#include "analysis/stage.h"
#include "joint/joint_fit.h"

namespace regarment {

/// A garment between edges where it may lie, fitted at the joint fit's coarsest level.
struct JointStart {
  SeenGarment seen;
  std::map<std::string, SolvedDimension> solved;
  std::map<std::string, HiddenEdge> hidden;
  JointTarget target;
  std::vector<MeasuredLength> lengths;
  JointFit coarse;
  std::vector<std::string> moved;  // names of the edges that are not where they were found
  double weight = 1;               // 0..1, how probable; those of all starts add up to 1
};

/// What may be worn: the garment between its edges as found, first, and between the most probable
/// other places of these. Throws NoGarmentError with the evidence for the edges as found; other
/// places that make no garment are left out.
std::vector<JointStart> joint_starts(const GarmentTemplate& garment, int layer, const Stage& stage,
                                     const Progress& progress);

/// Goes on from a start to the finest level.
JointFit finish_joint_fit(const GarmentTemplate& garment, const JointStart& start,
                          const Stage& stage, const Progress& progress);

}  // namespace regarment
