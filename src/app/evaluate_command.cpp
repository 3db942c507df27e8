#include <algorithm>
#include <thread>

#include "app/commands.h"
#include "app/evaluation_verdict.h"
#include "app/every_fit_options.h"
#include "base/one_line.h"
#include "evaluation/evaluate.h"
#include "evaluation/evaluation_json.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

void run_evaluate(const EvaluateArguments& a, Console& console) {
  const Evaluation evaluation = evaluate(evaluate_options(a), console.progress());
  const fs::path page = a.out / "evaluation.html";
  console.say(one_line(page.string(), 4096));
  if (console.wants_json()) console.answer(evaluation_json(evaluation));
  judge_evaluation(evaluation, page, console);
}

}  // namespace regarment
