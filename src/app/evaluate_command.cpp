#include <algorithm>
#include <thread>

#include "app/commands.h"
#include "base/error.h"
#include "base/one_line.h"
#include "evaluation/evaluate.h"
#include "evaluation/evaluation_json.h"
#include "evaluation/gate.h"
#include "garment/find_template.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// What `fit` would say to this command, before any is run.
void check_fit_command(const std::vector<std::string>& command,
                       const std::vector<std::string>& garments) {
  std::vector<const char*> words;
  words.reserve(command.size());
  for (const std::string& word : command) words.push_back(word.c_str());
  const Command parsed = parse_command_line(static_cast<int>(words.size()), words.data());
  const auto* fit = std::get_if<FitArguments>(&parsed);
  if (fit == nullptr || fit->garments != garments) {
    throw UsageError("options of fits may not name garments or ask for help");
  }
  if (fit->known.fix.empty() && fit->known.hint.empty()) return;
  AnalyzeOptions how;
  std::vector<GarmentTemplate> templates;
  templates.reserve(garments.size());
  for (const std::string& name : garments) templates.push_back(find_template(name));
  apply_known(fit->known, templates, how);
}

EvaluateOptions evaluate_options(const EvaluateArguments& a) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  EvaluateOptions how;
  how.table = a.table, how.out = a.out;
  how.scans = a.scans, how.estimates = a.estimates, how.baseline = a.baseline;
  how.only = a.only;
  how.gates = a.gates;
  how.fit_options = a.fit_options;
  how.program = fs::read_symlink("/proc/self/exe");
  how.jobs = a.jobs > 0 ? a.jobs : cores;
  how.threads = a.threads > 0 ? a.threads : std::max(1, cores / how.jobs);
  how.timeout = a.timeout;
  how.force = a.force, how.timing = a.timing;
  how.check_fit = check_fit_command;
  return how;
}

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

bool speaks_of_failures(const EvaluateArguments& a) {
  return std::any_of(a.gates.begin(), a.gates.end(),
                     [](const auto& text) { return parse_gate(text).statistic == "failures"; });
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

void run_evaluate(const EvaluateArguments& a, Console& console) {
  const Evaluation evaluation = evaluate(evaluate_options(a), console.progress());
  const fs::path page = a.out / "evaluation.html";
  console.say(one_line(page.string(), 4096));
  if (console.wants_json()) console.answer(evaluation_json(evaluation));
  throw_failed_gates(evaluation, console);
  if (!a.estimates && !speaks_of_failures(a)) throw_failed_scans(evaluation, page);
}

}  // namespace regarment
