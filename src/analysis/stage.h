#pragma once

#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "analysis/analyze.h"
#include "garment/garment_template.h"
#include "measure/garment_region.h"
#include "measure/observe.h"
#include "placement/place_garment.h"
#include "segmentation/segment.h"

namespace regarment {

/// Mean distance between the points of a cloud over the median distance to the nearest neighbour:
/// a random cloud's neighbours are half as far away as points in a regular grid would be.
inline constexpr double kCloudSpacing = 1.75;

/// What the garments of a scan share while they are found one after another.
struct Stage {
  const AnalyzeOptions& options;
  SurfaceSamples samples;
  Body body = {};
  std::vector<BodyPart> parts = {};      // per vertex
  std::vector<std::uint8_t> taken = {};  // per sample: belongs to a garment found before
  Labels labels = {};
  std::vector<std::uint8_t> cap = {};  // per triangle; empty for a cloud
  std::vector<std::string> warnings = {};
};

/// Edges of the garment on the scan, looked for outside of what other garments have taken.
GarmentEdges edges_on(const Stage& stage, const Pattern& pattern, const GarmentTemplate& garment,
                      int layer);

/// Per sample: 1 where it lies between the garment's edges and no other garment has it.
std::vector<std::uint8_t> cloth_of(const Stage& stage, const GarmentRegion& region);

/// A body's own shape may show two edges close together. Throws NoGarmentError when the edges of a
/// garment lie nearer to each other than any garment of its kind is long.
void check_lengths(const GarmentTemplate& garment, const std::vector<ObservedLength>& observed);

/// Heights for the placement; an edge hidden by another garment lies as far from the opposite edge
/// as the garment is long.
PlacementTarget placement_target(const GarmentEdges& edges, const Pattern& pattern);

/// The edges as curves in the result.
std::vector<EdgeCurve> edge_curves(const GarmentEdges& edges);

/// Mean distance of the draped garment to the cloth of the scan, and mean length of its springs
/// over rest length.
void judge_drape(const Stage& stage, const std::vector<std::uint8_t>& cloth, GarmentAnalysis& out);

/// Marks the samples as this garment's, its caps as caps, and counts its vertices.
void take(Stage& stage, const std::vector<std::uint8_t>& cloth,
          const std::vector<std::uint8_t>& caps, GarmentAnalysis& out);

/// Edges that are hidden or hardly seen, dimensions that end at the template's bounds.
void warn_about(const GarmentTemplate& garment, const GarmentEdges& edges,
                const GarmentAnalysis& found, std::vector<std::string>& warnings);

/// "54.0 cm".
std::string centimetres(double metres);

/// One garment by the direct method: edges on the scan itself, lengths between them, labels of what
/// lies inside; no cloth is simulated. Throws NoGarmentError with the evidence.
GarmentAnalysis measure_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                                Stage& stage);

/// One garment by the paper's search: draped again and again with other dimensions until Eq. (1) is
/// smallest, labelled by distance [Hasler et al. 2007]. Throws NoGarmentError with the evidence.
GarmentAnalysis anneal_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                               Stage& stage, const Progress& progress);

}  // namespace regarment
