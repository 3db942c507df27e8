#include "batch/merge_batch.h"

#include "base/error.h"
#include "batch/batch_plan.h"
#include "batch/batch_state.h"
#include "evaluation/scan_outcome.h"
#include "evaluation/sum_up.h"

namespace regarment {
namespace {

EvaluatedScan outcome(const EvaluationCase& about, const ScanStatus& status,
                      const BatchFolder& folder) {
  if (!status.failure) return finished_scan(about, folder.fit(about.name));
  return scan_without_result(about, *status.failure);
}

}  // namespace

Evaluation merge_batch(const BatchFolder& folder, const Manifest& manifest,
                       const std::vector<std::string>& gate_texts, const Progress& progress) {
  const BatchState state = batch_state(folder, manifest);
  if (state.ended() < state.scans.size()) {
    throw TemporaryError(folder.place().string() + ": " + state_line(state) +
                         "; run 'regarment batch' again");
  }
  const std::vector<EvaluationCase> cases = cases_of(manifest);
  std::vector<Gate> gates;
  for (const std::string& text : gate_texts) gates.push_back(parse_gate(text));
  check_gate_groups(gates, expected_groups(cases));
  Evaluation out;
  out.version = manifest.version;
  out.table = manifest.table.filename().string();
  out.fit_options = manifest.options;
  out.timing = false;
  const EvaluationFolder evaluation(folder.place());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    progress.report("merge", static_cast<double>(i) / static_cast<double>(cases.size()));
    out.scans.push_back(outcome(cases[i], *state.scans[i], folder));
  }
  progress.report("merge", 1);
  sum_up(out, gates, std::nullopt, evaluation, progress);
  return out;
}

}  // namespace regarment
