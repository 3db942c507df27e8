#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/cloth_levels.h"
#include "measure/observe.h"
#include "measure/section.h"

namespace regarment {

// What `observe` is made of; for the files observe*.cpp alone.

/// A garment round the trunk from its upper to its lower edge.
struct TrunkLevels {
  std::string upper, lower;        // names of the edges
  double length = 0;               // m, from one to the other over the cloth
  std::vector<LevelGirth> girths;  // at levels counted from the upper edge, ascending
};

/// The upper edge of a sleeve with its shoulder, in the upright plane through both its ends; the
/// section's angle 0 is upwards, 90 degrees towards the cuff.
struct UpperEdge {
  Vec3 neck, cuff;
  Section section;
};

/// Where a sleeve begins on its upper edge, and the girth of the chest it was found with, m.
struct ShoulderPoint {
  Vec3 at;
  double chest = 0;
};

/// One scan with the edges of one garment on it, and what measures between them. Borrows all.
struct Observer {
  const SurfaceSamples& samples;
  const Body& body;
  const GarmentEdges& edges;
  const std::vector<std::uint8_t>& cloth;  // per sample: 1 = on the garment
  const GarmentTemplate& garment;
  std::optional<TrunkLevels> trunk = std::nullopt;

  /// Any number of threads may measure at once.
  ObservedLength measure(const Observation& o) const;

  // One function per kind of observation; each returns the observation unseen when the scan lacks
  // what it needs.
  ObservedLength girth(const Observation& o) const;
  ObservedLength girth_at_offset(const Observation& o) const;
  ObservedLength path(const Observation& o) const;
  ObservedLength fork(const Observation& o) const;

  std::vector<int> on_cloth(const std::vector<int>& members) const;

  /// Slices of thin scans are thicker, and their gaps wider.
  double half_slice() const;
  double reach() const;

  const GarmentEdge* edge(const std::string& name) const;  // null: not found
  const LimbView& limb(const GarmentEdge& e) const { return edges.limbs.at(e.limb); }
  /// Where the edge is in the direction `phi` of its limb.
  Vec3 edge_point(const GarmentEdge& e, double phi) const;

  ObservedLength torso_girth(const Observation& o, const GarmentEdge& e) const;
  ObservedLength cuff_girth(const Observation& o, const GarmentEdge& e) const;
  ObservedLength level_girth(const Observation& o, const GarmentEdge& e) const;
  ObservedLength chest_girth(const Observation& o, const GarmentEdge& e) const;
  /// Girths from the upper to the lower edge of a garment round the trunk that has both.
  std::optional<TrunkLevels> trunk_levels() const;
  double trunk_top() const;  // m above the floor, up to where the trunk is cloth of its own
  UpperEdge upper_edge(const GarmentEdge& from, const GarmentEdge& to) const;
  /// Where on its upper edge a sleeve begins by the template's rule; nothing when its edges or the
  /// girth it depends on do not show.
  std::optional<ShoulderPoint> shoulder_point(const std::string& cuff) const;
  double centre_path(const GarmentEdge& from, const GarmentEdge& to, double phi) const;
};

}  // namespace regarment
