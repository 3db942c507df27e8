#include "app/evaluation_verdict.h"

#include <algorithm>

#include "base/error.h"
#include "evaluation/gate.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// Each failed gate has its line; the last one is the error.
void throw_failed_gates(const Evaluation& evaluation, Console& console) {
  std::vector<std::string> failed;
  for (const GateResult& gate : evaluation.gates) {
    if (!gate.passed) failed.push_back(why_failed(gate));
  }
  if (failed.empty()) return;
  for (std::size_t i = 0; i + 1 < failed.size(); ++i) console.complain(failed[i]);
  throw GateError(failed.back());
}

bool speaks_of_failures(const std::vector<GateResult>& gates) {
  return std::any_of(gates.begin(), gates.end(), [](const GateResult& gate) {
    return parse_gate(gate.text).statistic == "failures";
  });
}

void throw_failed_scans(const Evaluation& evaluation, const fs::path& page) {
  const GroupStatistics& all = evaluation.groups.front();
  if (all.failures == 0) return;
  const auto first = std::find_if(evaluation.scans.begin(), evaluation.scans.end(),
                                  [](const auto& scan) { return scan.failure.has_value(); });
  throw NoGarmentError(std::to_string(all.failures) + " of " + std::to_string(all.scans) +
                       " scans came to no result, first " + first->about.name + ": " +
                       first->failure->line + "; see " + page.string());
}

}  // namespace

void judge_evaluation(const Evaluation& evaluation, const fs::path& page, Console& console) {
  throw_failed_gates(evaluation, console);
  // Of estimates no scan fails; those that are missing are the other program's.
  if (!evaluation.estimates && !speaks_of_failures(evaluation.gates)) {
    throw_failed_scans(evaluation, page);
  }
}

}  // namespace regarment
