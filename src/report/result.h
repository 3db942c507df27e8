#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/analysis.h"
#include "report/deviation.h"
#include "report/label_score.h"
#include "report/result_search.h"
#include "scan/finding.h"

namespace regarment {

/// What the user asked for, as far as the result records it.
struct ReportOptions {
  std::uint64_t seed = 1;
  // Options given on the command line, name without dashes and value ("units", "mm").
  std::vector<std::pair<std::string, std::string>> options;
  // Every option there is for this method, chosen or not, with the value it had.
  std::vector<std::pair<std::string, std::string>> settings;
  // Paths as given, and how many threads ran: written only with `timing`.
  std::string scan_path;
  int threads = 1;
  int pixel_ratio = 1;  // of the pictures, 1 or 2: see draw_pictures
  std::string state;    // bytes of state.bin (analysis/scan_state.h); empty: none is left
  bool refit = false;   // the scan came from the state of an earlier fit
  // False leaves out times, thread count and paths, so that two runs give the same bytes.
  bool timing = true;
  std::optional<LabelScore> label_score;
};

/// What a dimension would be if edges lay at another place where they may as well lie.
struct ResultRivalLength {
  std::vector<std::string> edges;
  double value_cm = 0, weight = 0;
};

/// One dimension in people's units; the fields are those of result.json (schemas/).
struct ResultMeasurement {
  std::string name, code, title, definition, how_to_measure;
  bool circumference = false;
  double value_cm = 0, low_cm = 0, high_cm = 0;
  std::optional<double> worn_cm;
  std::optional<double> worn_fit_cm, worn_line_cm, worn_scan_cm;  // what worn_cm was weighed from
  std::vector<ResultRivalLength> rivals;                          // most probable first
  bool observable = true;
  bool fixed = false;  // given by a person and held
  std::optional<double> truth_cm, published_cm, tol_minus_cm, tol_plus_cm;

  std::optional<double> error_cm() const;  // value - truth
};

/// Another height at which an edge may as well lie.
struct ResultRival {
  double height_cm = 0, weight = 0;
};

struct ResultEdge {
  std::string name, evidence;
  double standard_error_mm = 0, coverage = 0, length_cm = 0, height_cm = 0;
  std::vector<ResultRival> rivals = {};  // most probable first
  // Of the flat garment, where it is measured; and of the person 2 cm beyond the edge, where that
  // is seen all round.
  std::optional<double> flat_cm = {}, beside_cm = {};

  std::optional<double> ease_cm() const;  // flat less beside
};

/// How far a garment's sides differ.
struct ResultAsymmetry {
  std::string name, sides;  // a dimension, and "left_right" or "front_back"
  double difference_cm = 0, spread_cm = 0;
};

struct ResultGarment {
  std::string template_name, title;
  int layer = 1;
  std::vector<ResultMeasurement> measurements;
  std::vector<ResultEdge> edges;
  std::vector<ResultAsymmetry> asymmetry;
  double mean_distance_m = 0, mean_stretch = 1;
  std::optional<double> silhouette;          // E_sil, where no search tells it
  std::optional<ResultSearch> search;        // of the methods that search
  std::optional<ResultDeviation> deviation;  // of the methods that drape
  std::size_t vertices_labelled = 0;
};

struct ResultScan {
  std::string file, sha256, units, up, front;
  bool units_guessed = true, up_guessed = true, front_guessed = true;
  double front_confidence = 1, noise_mm = 0, spacing_mm = 0, height_cm = 0;
  std::size_t vertices = 0, triangles = 0, caps = 0, outliers = 0, holes = 0;
  std::vector<Finding> findings;  // about the scan itself; `Result::warnings` are about garments
  std::optional<std::string> path;
};

/// A picture stored beside result.json.
struct StoredFigure {
  std::string kind;           // "scan", "segmentation", "placement", "drape", "deviation"
  std::string view;           // "front", "left", "back", "right"
  std::string file;           // "pictures/scan-front.jpg"
  int width = 0, height = 0;  // pixels
};

/// Everything result.json holds: plain data, enough to make the page again.
struct Result {
  std::string version, method, command;
  std::uint64_t seed = 1;
  std::vector<std::pair<std::string, std::string>> options, settings;
  std::optional<int> threads;
  bool refit = false;              // made from the state of an earlier fit
  std::string fabric = "unknown";  // as a person said
  ResultScan scan;
  std::vector<ResultGarment> garments;
  std::size_t person = 0, unsure = 0;       // vertices
  std::vector<std::size_t> garment_counts;  // vertices per garment
  std::optional<LabelScore> label_score;
  std::vector<std::pair<std::string, double>> landmarks_cm;
  std::vector<std::string> warnings;
  std::vector<StoredFigure> figures;
  std::vector<std::pair<std::string, double>>
      timing_s;  // stages, then "total"; empty without timing
};

/// Below this probability a vertex's label counts as unsure.
inline constexpr float kUnsureBelow = 0.75F;

/// The result of an analysis; `templates` are those of its garments, in their order. Lengths are
/// rounded to 0.001 mm. Throws InvalidInput when the vectors' sizes contradict each other or a
/// number is not finite.
Result make_result(const Analysis& analysis, const std::vector<GarmentTemplate>& templates,
                   const ReportOptions& options);

/// The text of result.json, valid by schemas/result.schema.json.
std::string result_json(const Result& result);

/// Reads it back: `parse_result(result_json(r))` gives `result_json` of the same bytes. The text is
/// checked by the schema; throws ReadError naming the place of what is wrong.
Result parse_result(const std::string& json, const std::string& name_for_messages);

}  // namespace regarment
