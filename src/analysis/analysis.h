#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fit/fit_trace.h"
#include "garment/fabric.h"
#include "garment/pattern.h"
#include "joint/sides.h"
#include "scan/scan.h"
#include "segmentation/border_lines.h"

namespace regarment {

/// What tells of one worn dimension, m. They are found in different ways, so how far they lie apart
/// says how far each may be off.
struct WornSources {
  double fit = 0;              // the dimension that explains the garment on the scan as a whole
  double line = 0;             // the template's line on the draped garment
  std::optional<double> scan;  // measured on the scan itself, without the garment
  bool hanging = false;        // `scan` runs along folds that hang: see ObservedLength
};

/// What a dimension would be if edges lay at another place where they may as well lie.
struct RivalLength {
  std::vector<std::string> edges;  // names of those that would lie elsewhere
  double flat = 0;                 // m
  double weight = 0;               // how probable this is, 0..1
};

/// One named dimension of one garment, as found. All lengths in metres.
struct Measurement {
  std::string name, code;
  double flat = 0.0;                   // the flat garment, as a tape reads it on a table
  double low = 0.0, high = 0.0;        // 90 % interval of `flat`
  std::optional<double> worn;          // the same line as it lies on the body
  std::optional<WornSources> sources;  // of `worn`, by the method joint
  std::vector<RivalLength> rivals;     // most probable first; the interval takes them into account
  bool fixed = false;                  // a person knows it: `flat` is what they said, held exactly
  bool observable = true;              // false: the scan says nothing, `flat` is a probable value
  std::optional<double> truth;         // given by the user
  std::optional<double> tol_minus, tol_plus, published;  // given by the user, m
};

/// Another place where an edge may as well lie.
struct EdgeRival {
  double height = 0;  // m above the floor, mean over the curve
  double weight = 0;  // how probable it is, 0..1
};

/// A garment edge found on the scan, as a closed curve.
struct EdgeCurve {
  std::string name;           // "hem"
  std::vector<Vec3> points;   // body frame, closed, first not repeated
  double standard_error = 0;  // m, of the curve's position across the edge
  double coverage = 0;        // share of the loop, by angle, where the scan shows the edge, 0..1
  std::string evidence;       // what showed it: "step", "colour", "drop", "crease", ...
  // Of edges round the trunk, most probable first; with the edge itself their weights add up to 1.
  std::vector<EdgeRival> rivals = {};
};

/// How far a garment's sides differ in one dimension, by a fit that does not take them for alike.
struct SideDifference {
  std::string dimension;
  Sides sides = Sides::LeftRight;
  double difference = 0;  // m, the left side's (front's) length less the other's
  double spread = 0;      // m, half of the 90 % interval of the difference
};

struct GarmentAnalysis {
  std::string template_name;
  int layer = 1;                          // 1 = outermost
  std::vector<Measurement> measurements;  // in the template's order
  Dimensions dimensions;                  // m, what `pattern` shows
  Pattern pattern;                        // flat, at `dimensions`
  std::vector<Vec3> placed;  // start of the garment, body frame, one per pattern vertex
  std::vector<Vec3> draped;  // the garment on the scan, body frame, one per pattern vertex
  std::vector<EdgeCurve> edges;
  std::vector<BorderLine> borders;  // where its label ends, one per edge of the pattern that shows
  std::vector<SideDifference> asymmetry;  // those that exceed their spread
  std::size_t vertices_labelled = 0;
  double mean_distance = 0.0;        // m, draped garment to the scan, area-weighted mean
  double mean_stretch = 1.0;         // mean of spring length over rest length
  std::optional<double> silhouette;  // E_sil of Eq. (1) for the draped garment
  /// Per scan vertex, m: from the draped garment to the vertex, positive outside of the garment;
  /// NaN where the vertex is not this garment's. Empty when the method drapes nothing.
  std::vector<float> deviation;
  std::optional<FitTrace> trace;  // of the methods that search
  ErrorTerms terms;               // of Eq. (1) at the result, when there is a trace
};

struct StageTime {
  std::string stage;
  double seconds;
};

/// Everything found for one scan. Body frame, metres.
struct Analysis {
  Scan scan;
  std::string method;                     // "direct"
  Fabric fabric = Fabric::Unknown;        // as a person said
  std::vector<GarmentAnalysis> garments;  // outermost first
  std::vector<std::uint8_t> labels;       // per vertex: 0 person, i = i-th garment
  std::vector<float> label_probability;   // per vertex: how sure the label is, 0.5..1
  std::vector<std::uint8_t>
      cap;  // per triangle: 1 = invented surface closing a hem; empty for a cloud
  std::map<std::string, double>
      landmarks;  // name -> height above floor, m ("crotch", "waist", ...)
  std::vector<std::string> warnings;
  std::vector<StageTime> times;
};

}  // namespace regarment
