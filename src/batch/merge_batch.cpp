#include "batch/merge_batch.h"

#include <algorithm>

#include "base/error.h"
#include "batch/batch_plan.h"
#include "batch/batch_state.h"
#include "batch/measurements_table.h"
#include "evaluation/scan_outcome.h"
#include "evaluation/sum_up.h"
#include "geometry/parallel.h"

namespace regarment {
namespace {

EvaluatedScan outcome(const EvaluationCase& about, const ScanStatus& status,
                      const BatchFolder& folder) {
  if (!status.failure) return finished_scan(about, folder.fit(about.name));
  return scan_without_result(about, *status.failure);
}

std::vector<EvaluatedScan> outcomes(const std::vector<EvaluationCase>& cases,
                                    const BatchState& state, const BatchFolder& folder, int workers,
                                    const Progress& progress) {
  constexpr std::size_t kAtOnce = 64;  // between two looks whether to go on
  std::vector<EvaluatedScan> out(cases.size());
  limit_threads(workers);
  for (std::size_t first = 0; first < cases.size(); first += kAtOnce) {
    progress.report("merge", static_cast<double>(first) / static_cast<double>(cases.size()));
    const std::size_t count = std::min(kAtOnce, cases.size() - first);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = first + begin; i < first + end; ++i) {
        out[i] = outcome(cases[i], *state.scans[i], folder);
      }
    });
  }
  progress.report("merge", 1);
  return out;
}

}  // namespace

Evaluation merge_batch(const BatchFolder& folder, const Manifest& manifest,
                       const std::vector<std::string>& gate_texts, int workers,
                       const Progress& progress) {
  const BatchState state = batch_state(folder, manifest);
  if (state.ended() < state.scans.size()) {
    throw TemporaryError(folder.place().string() + ": " + state_line(state) +
                         "; run 'regarment batch' again");
  }
  const std::vector<EvaluationCase> cases = cases_of(manifest);
  std::vector<Gate> gates;
  gates.reserve(gate_texts.size());
  for (const std::string& text : gate_texts) gates.push_back(parse_gate(text));
  check_gate_groups(gates, expected_groups(cases));
  Evaluation out;
  out.version = manifest.version;
  out.table = manifest.table.filename().string();
  out.fit_options = manifest.options;
  out.timing = false;
  const EvaluationFolder evaluation(folder.place());
  out.scans = outcomes(cases, state, folder, workers, progress);
  folder.write("measurements.csv", measurements_table(folder, manifest, state));
  sum_up(out, gates, std::nullopt, evaluation, progress);
  return out;
}

}  // namespace regarment
