#pragma once

#include <map>
#include <string>
#include <vector>

#include "joint/bound_inside.h"
#include "joint/joint_model.h"

namespace regarment {

/// What of a scan a garment is fitted to. Body frame, metres.
struct JointTarget {
  std::vector<Vec3> points, normals;  // cloth seen, evenly spread; normals unit, outward
  std::vector<double> areas;          // m^2 of cloth each stands for
  struct Edge {
    std::vector<Vec3> curve;      // closed
    double standard_error = 0.0;  // m, across the curve
    bool as_one = false;          // its parts err together: the whole edge counts once
  };
  std::map<std::string, Edge> edges;  // by the pattern's names; absent: anywhere
  std::vector<OuterGarment> outer;    // worn over this one
};

/// Which scan counts for which garment.
struct MatchOptions {
  double reach = 0.08;           // m, scan further off is something else
  double robust = 0.02;          // m, scan this far behind the cloth counts a quarter
  double robust_outside = 0.06;  // m, the same in front of it
  double uncovered = 0.004;      // m, scan this far beside the cloth draws it along
  double ridge_share = 1.0;      // of the weight it does so with
  double unseen = 0.05;     // least share of its weight that a spring keeps when it is too short
  double min_cosine = 0.4;  // between the normals of scan and garment
};

/// Per particle: share of the cloth round it that model.surface shows, 0..1.
std::vector<double> coverage(const JointModel& model);

/// Joins every point of the target to the nearest point of the garment that faces as it does, and
/// every particle of a seen edge to its curve; replaces model.surface and model.edges. What lies
/// nearest on an open edge of the garment is left to the edges.
void match_scan(const JointTarget& target, const std::vector<Vec3>& x, const MatchOptions& options,
                JointModel& model);

}  // namespace regarment
