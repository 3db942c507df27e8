#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "garment/pattern.h"
#include "measure/edge_finder.h"
#include "measure/hanging_folds.h"

namespace regarment {

/// Another place where an edge may be.
struct EdgeHypothesis {
  FoundEdge edge;
  double weight = 0;  // 0..1, how probable it is
};

/// A named edge of a garment on the scan.
struct GarmentEdge {
  std::string limb;                    // "torso", "left_arm", "right_arm", "neck"
  bool garment_above = true;           // the garment lies at larger s of the limb's axis
  FoundEdge found;                     // the most probable place
  std::vector<EdgeHypothesis> rivals;  // the others, likeliest first; their weights and that of
                                       // `found` add up to 1; empty when there is one answer
  HangingFolds folds;                  // of a hem, lower than `found`
  std::optional<FoundEdge> clearest;   // the place of most evidence, where that is another one
  bool covered =
      false;  // hidden by a garment that was taken off before: this is where it is cut off
};

/// The edges of one garment on a scan.
struct GarmentEdges {
  std::map<std::string, LimbView> limbs;
  std::map<std::string, GarmentEdge> edges;
  bool upper_body = false;  // the garment has sleeves or a neck
  /// Of a garment with sleeves or a neck: the place where cloth that hangs from the waist would
  /// most likely begin. A skirt's wearer shows such an edge, a T-shirt's does not.
  FoundEdge top_of_other;
};

/// Is a loose point part of the torso's outer surface, a piece cut off by holes in the scan?
bool beside_torso(const LimbView& torso, const Vec3& p);

/// Looks for all open edges of a garment on the body. `taken` marks samples that belong to garments
/// found before (one per sample, or empty): they are not looked at, and an edge that ends at them
/// is covered. `pattern` is the garment at any dimensions: it tells which edges there are. `said`:
/// heights above the floor (m) of edges that a person gave: such an edge is looked for within 3 cm
/// of its height, a cuff within 3 cm along the arm (find_cuff.h), and taken from there in any case;
/// a neckline is not among them. `another_below`: a garment that
/// is looked for later shows below this one, so that of two hems the higher is this one's.
/// Throws NoGarmentError with the evidence when the edges the garment cannot do without are
/// missing.
GarmentEdges find_garment_edges(const SurfaceSamples& samples, const Body& body,
                                const Pattern& pattern, const std::string& title,
                                const std::vector<std::uint8_t>& taken,
                                const std::map<std::string, double>& said = {},
                                bool another_below = false);

}  // namespace regarment
