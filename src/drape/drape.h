#pragma once

#include "base/progress.h"
#include "drape/attraction.h"
#include "drape/cloth.h"
#include "drape/held_edge.h"

namespace regarment {

struct DrapeOptions {
  // k_s of sec. 3.2, N/m. Larger keeps lengths more strictly.
  double spring_stiffness = 100.0;
  // k_d of sec. 3.2, N s/m. Larger takes motion along the springs out faster.
  double spring_damping = 0.05;
  // k_e of Bridson et al. 2003, N m. Larger makes smoother folds.
  double bending_stiffness = 1e-4;
  // k_d of Bridson et al. 2003, N s. Larger takes folding motion out faster.
  double bending_damping = 1e-4;
  // k_a of sec. 3.2, N/m. Larger follows the scan more closely and shows less of a wrong size.
  double attraction_stiffness = 10.0;
  // Share of k_a that a step expects along a smooth surface, 0..1. Larger slides more slowly; where
  // the cloth comes to rest does not depend on it.
  double attraction_grip = 0.01;
  AttractionOptions attraction;
  // Particles whose closest point keeps jumping stop looking at normals, then are pulled less and
  // less (drape/hesitation.h); false: as printed.
  bool hesitation = true;
  // Downwards, m/s^2; 0 as in the paper, whose cloth is held by the attraction alone.
  double gravity = 0.0;
  // Cloth-scan contact [sec. 3.2: off, it works against the attraction and lengths come out too
  // large].
  bool collisions = false;
  double contact_stiffness = 200.0;  // N/m
  double contact_thickness = 0.002;  // m, the cloth stays this far outside of the scan

  double first_step = 0.02, least_step = 1e-4, largest_step = 0.25;  // s
  // A step is repeated with half its time when a particle would move farther, m, or the mean
  // stretch would change by more. Smaller is safer and slower.
  double largest_move = 0.05, largest_stretch_change = 0.1;
  // Each step's linear system is solved until its residual has fallen to this share. Smaller costs
  // time and gains little, since the next step sees what is left. With gravity take 1e-5: what is
  // left of it would shake the cloth.
  double solver_tolerance = 1e-2;
  int max_steps = 100;
  // At rest when the root mean square of the particles' speeds is below this, m/s, and the mean
  // distance (m) and the mean stretch change by less than these per step, three steps in a row of
  // at least `first_step`. Smaller lets the cloth slide on longer along the scan.
  double rest_speed = 0.002, rest_distance_change = 1e-5, rest_stretch_change = 1e-4;

  void check() const;  // throws InvalidInput naming the field and its value
};

enum class DrapeEnding { CameToRest, StepLimit };

/// What a drape came to.
struct DrapeOutcome {
  DrapeEnding ending = DrapeEnding::StepLimit;
  int steps = 0;             // accepted
  int rejected = 0;          // repeated with a smaller step
  double mean_speed = 0;     // m/s at the end, root mean square over the particles
  double largest_speed = 0;  // m/s at the end, of one particle
  double mean_distance = 0;  // E_dist, m
  double mean_stretch = 1;   // E_stretch
};

/// Lets the cloth move until it lies at rest on the scan [sec. 3.2]: springs, bending and
/// attraction, integrated semi-implicitly [Baraff and Witkin 1998] with an adaptive step. Moves
/// `cloth`. Deterministic. Only the resting state is of interest, so the steps are long and few:
/// about ten when dimensions changed by a few per cent, thirty from a placement.
///
/// `held`: edges that are drawn to a curve; none as in the paper. `shares`: how strongly each
/// element of the scan attracts, see `attract`; or empty.
///
/// One departure from the paper: a particle whose closest point keeps jumping between parts of the
/// scan stops looking at normals and is then pulled less and less, or it would never rest.
///
/// Throws InvalidInput for cloth that is empty, not finite or whose parts do not match, and when
/// `scan` is empty; Stopped from progress, the cloth then lies where the last step brought it.
DrapeOutcome drape(Cloth& cloth, const ClosestPoint& scan, const DrapeOptions& options = {},
                   const Progress& progress = {}, const std::vector<HeldEdge>& held = {},
                   const std::vector<float>& shares = {});

}  // namespace regarment
