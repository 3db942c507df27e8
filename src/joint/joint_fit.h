#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "joint/joint_model.h"
#include "joint/length_evidence.h"
#include "joint/match_scan.h"

namespace regarment {

/// A pass over the fit at one resolution.
struct JointLevel {
  double edge_length = 0.025;  // m, of the pattern's triangles
  int rounds = 10;             // of matching and stepping
  double robust = 0.02;        // m, see MatchOptions
};

struct JointOptions {
  // From coarse to fine.
  std::vector<JointLevel> levels = {{0.05, 12, 0.04}, {0.02, 10, 0.015}};
  JointScales scales;
  InsideOptions inside;
  MatchOptions match;  // its `robust` comes from the levels
  Dimensions fixed;    // m: known, stay as they are

  void check() const;  // throws InvalidInput
};

/// What the joint fit found.
struct JointFit {
  Dimensions dimensions;               // m, of the worn garment: its lengths as they are seen
  Pattern pattern;                     // at `dimensions`, finest level
  std::vector<Vec3> draped;            // per pattern vertex, body frame, m
  double surface_error = 0;            // m, root mean square of scan off the garment, weighted
  std::map<std::string, double> worn;  // m, the measured lines as they lie on the body
  double matched = 0;                  // share of the target's area that lies on the garment, 0..1
};

/// Fits particles and dimensions of a garment to a scan at once, coarse to fine. `start`:
/// dimensions that make a garment; `pattern` and `placed`: the garment at `start`, one position per
/// pattern vertex, at any edge length. `lengths` may be empty. Throws InvalidInput for sizes that
/// do not match and options out of range, Stopped when progress says so.
JointFit joint_fit(const GarmentTemplate& garment, const Dimensions& start, const Pattern& pattern,
                   const std::vector<Vec3>& placed, const JointTarget& target,
                   const std::vector<MeasuredLength>& lengths, const JointOptions& options,
                   const Progress& progress);

}  // namespace regarment
