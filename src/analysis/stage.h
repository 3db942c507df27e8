#pragma once

#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "analysis/analyze.h"
#include "garment/garment_template.h"
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
  // Per garment asked for: another one follows that hangs from the waist as well.
  std::vector<bool> another_below = {};
  std::vector<OuterGarment> outer = {};  // found before and draped, outermost first
  Labels labels = {};
  std::vector<std::uint8_t> cap = {};  // per triangle; empty for a cloud
  std::vector<std::string> warnings = {};
};

/// What the scan itself shows of a garment.
struct SeenGarment {
  GarmentEdges edges;
  std::vector<std::uint8_t> cloth;  // per sample: between the edges, of no garment found before
  std::vector<ObservedLength> observed;
};

/// Looks for a garment outside of what others have taken, and measures it. `pattern` is the
/// garment's. Throws NoGarmentError with the evidence, also when two of its edges lie nearer to
/// each other than any garment of its kind is long: a body's own shape may show such edges.
SeenGarment look_for(const GarmentTemplate& garment, const Pattern& pattern, int layer,
                     const Stage& stage);

/// The same with the edges known.
SeenGarment look_between(GarmentEdges edges, const GarmentTemplate& garment, const Stage& stage);

/// A garment that hangs from its top edge stays up only if something below is wider: throws
/// NoGarmentError when nothing is. What a person said (an edge's height, a dimension) is not
/// doubted.
void check_stays_up(const GarmentTemplate& garment, const Dimensions& dimensions,
                    const GarmentEdges& edges, const Stage& stage);

/// Heights for the placement; an edge hidden by another garment lies as far from the opposite edge
/// as the garment is long.
PlacementTarget placement_target(const GarmentEdges& edges, const Pattern& pattern);

/// m above the floor; 0 for no points.
double mean_height(const std::vector<Vec3>& points);

/// The edges as curves in the result.
std::vector<EdgeCurve> edge_curves(const GarmentEdges& edges);

/// Mean distance of the draped garment to the cloth of the scan, and mean length of its springs
/// over rest length.
void judge_drape(const Stage& stage, const std::vector<std::uint8_t>& cloth, GarmentAnalysis& out);

/// What of the scan neither attracts cloth nor shows in silhouettes: outliers, and the caps that a
/// reconstruction put under a hem, which the paper's authors cut out by hand (Fig. 5). Per triangle
/// of a mesh, per point of a cloud. `caps`: per triangle, or empty.
std::vector<std::uint8_t> masked_parts(const Scan& scan, const std::vector<std::uint8_t>& caps);

/// E_sil of Eq. (1) at the result, for the garments that no search has judged already.
void judge_outlines(const Scan& scan, const std::vector<std::uint8_t>& caps,
                    std::vector<GarmentAnalysis>& garments);

/// How far each vertex labelled as this garment's lies outside of the draped garment, m; NaN for
/// the others.
std::vector<float> deviation_of(const Scan& scan, const GarmentAnalysis& garment,
                                const Labels& labels);

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

/// One garment by the joint fit: edges on the scan, then particles and dimensions at once. Throws
/// NoGarmentError with the evidence.
GarmentAnalysis joint_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                              Stage& stage, const Progress& progress);

/// One garment by the paper's search: draped again and again with other dimensions until Eq. (1) is
/// smallest, labelled by distance [Hasler et al. 2007]. Throws NoGarmentError with the evidence.
GarmentAnalysis anneal_garment(const Scan& scan, const GarmentTemplate& garment, int layer,
                               Stage& stage, const Progress& progress);

}  // namespace regarment
