#include "evaluation/scan_outcome.h"

#include <algorithm>

#include "base/error.h"
#include "base/one_line.h"
#include "evaluation/border_distance.h"
#include "report/files.h"
#include "report/label_score.h"
#include "report/result.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostResultBytes = 64U << 20U;
constexpr double kMillimetres = 1000;

double metres_in(const std::string& unit) {
  if (unit == "mm") return 0.001;
  if (unit == "cm") return 0.01;
  return unit == "inch" ? 0.0254 : 1.0;
}

const ResultMeasurement* find(const Result& result, const TrueDimension& truth) {
  for (const ResultGarment& garment : result.garments) {
    if (garment.layer != truth.layer) continue;
    for (const ResultMeasurement& m : garment.measurements) {
      if (m.name == truth.measurement) return &m;
    }
  }
  return nullptr;
}

std::optional<FoundDimension> found(const Result& result, const TrueDimension& truth) {
  const ResultMeasurement* m = find(result, truth);
  if (m == nullptr) return std::nullopt;
  return FoundDimension{m->value_cm, m->low_cm, m->high_cm, m->worn_cm, m->observable};
}

// Vertices that lie nowhere are part of no border.
void leave_out_nowhere(Mesh& mesh, std::vector<std::uint8_t>& truth) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].allFinite()) continue;
    mesh.positions[i].setZero();
    truth[i] = 255;
  }
}

LabelAgreement agreement(const EvaluationCase& about, const Result& result,
                         const fs::path& folder) {
  Mesh mesh = read_mesh_sandboxed(about.scan).mesh;
  const auto labels = read_labels(folder / "labels.u8", mesh.positions.size());
  auto truth = read_labels(*about.labels, mesh.positions.size());
  const LabelScore score = score_labels(labels, truth, about.garments.size());
  LabelAgreement out;
  out.mean_iou = score.mean_iou;
  for (std::size_t i = 0; i < score.iou.size(); ++i) {
    if (score.iou[i])
      out.class_iou.emplace_back(i == 0 ? "person" : about.garments[i - 1], *score.iou[i]);
  }
  leave_out_nowhere(mesh, truth);
  out.border_mm = border_distance(mesh, labels, truth);
  if (out.border_mm) *out.border_mm *= metres_in(result.scan.units) * kMillimetres;
  return out;
}

std::string kind_of(const ResultScan& scan) {
  if (scan.triangles == 0) return "cloud";
  return scan.holes > 0 ? "open" : "closed";
}

std::string without_name(const std::string& line) {
  constexpr std::string_view kName = "regarment: ";
  return line.starts_with(kName) ? line.substr(kName.size()) : line;
}

}  // namespace

std::string failure_kind(const ChildEnd& end) {
  if (end.timed_out) return "time-out";
  switch (end.status) {
    case 1:
      return "internal error";
    case 2:
      return "wrong usage";
    case 3:
      return "unreadable or no person";
    case 4:
      return "not the garment asked for";
    case 75:
      return "temporary failure";
    default:
      return end.status >= 128 ? "crash" : "failure";
  }
}

EvaluatedScan scan_without_result(const EvaluationCase& about, ScanFailure failure) {
  EvaluatedScan out;
  out.about = about;
  if (out.about.kind.empty()) out.about.kind = "unknown";
  out.failure = std::move(failure);
  return out;
}

EvaluatedScan failed_scan(const EvaluationCase& about, const ChildEnd& end, long timeout) {
  ScanFailure failure{failure_kind(end), end.status, without_name(end.last_line)};
  if (end.timed_out) {
    failure.line = "not done after " + std::to_string(timeout) + " s; give more with --timeout";
  } else if (end.status >= 128) {
    failure.line = "ended by signal " + std::to_string(end.status - 128) +
                   (failure.line.empty() ? "" : "; last it said: " + failure.line);
  }
  return scan_without_result(about, std::move(failure));
}

EvaluatedScan finished_scan(const EvaluationCase& about, const fs::path& folder) {
  try {
    const Result result =
        parse_result(read_file(folder / "result.json", kMostResultBytes), "result.json");
    EvaluatedScan out;
    out.about = about;
    if (out.about.kind.empty()) out.about.kind = kind_of(result.scan);
    for (const TrueDimension& truth : about.dimensions) out.found.push_back(found(result, truth));
    if (about.frame.said())
      out.frame_right = about.frame.agrees(result.scan.units, result.scan.up, result.scan.front);
    if (!result.timing_s.empty()) out.seconds = result.timing_s.back().second;
    if (about.labels) out.labels = agreement(about, result, folder);
    out.report = "fits/" + about.name + "/report.html";
    return out;
  } catch (const ReadError& error) {
    return scan_without_result(
        about, {"unreadable or no person", error.exit_status(), one_line(error.what(), 500)});
  }
}

}  // namespace regarment
