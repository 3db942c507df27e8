#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace regarment {

/// What a table says about one dimension of one scan. Centimetres.
struct TrueDimension {
  std::size_t line = 0;  // of the table
  int layer = 1;         // 1 = outermost
  std::string template_name, measurement, code;
  bool circumference = false;
  double truth_cm = 0;  // the flat garment, > 0
  std::optional<double> worn_cm, published_cm;
  std::optional<double> tol_minus_cm, tol_plus_cm;  // >= 0
  std::optional<bool> observable;  // whether the scan shows it, where the table says so

  bool hidden() const { return observable && !*observable; }
  /// Whether an error (estimate - truth, cm) is one its tolerance allows, ends included; see
  /// report/judgement.h for what counts where none is given.
  bool tolerates(double error_cm) const;
};

/// How a scan's file lies in space, where a table says so.
struct TrueFrame {
  std::string units, up;           // "mm", "+z"; empty: not said
  std::vector<std::string> front;  // axes the front may be nearest to; empty: not said

  bool said() const { return !units.empty() || !up.empty() || !front.empty(); }
  bool agrees(const std::string& found_units, const std::string& found_up,
              const std::string& found_front) const;
};

/// One scan of a table, with everything that is said about it.
struct EvaluationCase {
  std::string name;                             // of its own: a folder's name, "skirt-1.mesh"
  std::filesystem::path scan;                   // may not exist; then its fit says so
  std::string garment;                          // what the scan shows: scans of one thing have one
  std::vector<std::string> garments;            // templates, outermost first
  std::vector<TrueDimension> dimensions;        // none: its truth is not known
  std::optional<std::filesystem::path> labels;  // true labels, one byte per vertex
  std::vector<std::string> options;             // of its fit alone
  std::string kind;                             // "cloud", "open", "closed", ...; empty: look
  std::vector<std::string> damage;
  TrueFrame frame;
  std::string truth_rows;  // what the table says, in one text: changes when any of it does
};

/// What was found for one dimension.
struct FoundDimension {
  double value_cm = 0;
  std::optional<double> low_cm, high_cm, worn_cm;  // low and high: both or none
  bool observable = true;
};

/// How labels agree with true ones.
struct LabelAgreement {
  double mean_iou = 0;                                    // over the classes there are
  std::vector<std::pair<std::string, double>> class_iou;  // "person", then the templates
  std::optional<double> border_mm;                        // see border_distance
};

/// Why there is no result.
struct ScanFailure {
  std::string kind;  // "no person or unreadable", "time-out", ...; see failure_kind
  int status = 0;
  std::string line;  // what the program said
};

/// A scan and what came of it.
struct EvaluatedScan {
  EvaluationCase about;
  std::optional<ScanFailure> failure;
  std::vector<std::optional<FoundDimension>> found;  // one per dimension; empty after a failure
  std::optional<LabelAgreement> labels;
  std::optional<bool> frame_right;  // units, up and front; none where the truth is not known
  std::optional<double> seconds;
  std::string report;  // where its report is, seen from the page; empty: there is none

  /// Mean absolute error of the dimensions the scan shows, cm; none where there is none.
  std::optional<double> mean_error_cm() const;
};

}  // namespace regarment
