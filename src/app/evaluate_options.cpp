#include "app/evaluate_options.h"

#include <CLI/CLI.hpp>

#include "app/every_fit_options.h"
#include "app/one_each.h"
#include "base/error.h"

namespace regarment {

void add_evaluate_options(CLI::App& evaluate, EvaluateArguments& a) {
  evaluate.add_option("TABLE", a.table, "CSV table of scans and their true dimensions")->required();
  evaluate.add_option("--out", a.out, "Folder of the evaluation; finished fits in it are kept")
      ->required();
  evaluate.add_flag("--force", a.force, "Make every fit again");
  evaluate.add_option("--scans", a.scans, "Another folder to find scans in");
  evaluate.add_option("--only", a.only, "Only scans whose name matches, with * and ?");
  evaluate.add_option("--estimates", a.estimates,
                      "Compare the estimates of this table; fit nothing");
  evaluate.add_option("--baseline", a.baseline, "An evaluation.json of before to compare with");
  one_each(evaluate.add_option(
      "--gate", a.gates,
      "A condition such as \"mae_cm<=1.0\" or \"skirt.hip.p95_cm<2\"; repeat for more"));
  evaluate.add_option("--jobs", a.jobs, "Fits at once; as many as there are cores by default")
      ->check(CLI::Range(1, 256));
  evaluate.add_option("--threads", a.threads, "Threads of each fit; the cores shared by default")
      ->check(CLI::Range(1, 256));
  evaluate.add_option("--timeout", a.timeout, "Longest time of a fit, s")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  evaluate.add_flag("!--no-timing", a.timing,
                    "Leave out times, so that two evaluations give the same bytes");
  add_every_fit_options(evaluate, a.fit_options);
}

void check_evaluate_options(const EvaluateArguments& a) {
  if (!a.estimates) return;
  const bool fits = a.scans || a.force || !a.only.empty() || !a.fit_options.empty();
  if (fits) {
    throw UsageError(
        "--estimates compares without fitting; leave out --scans, --only, --force and options of "
        "fits");
  }
}

}  // namespace regarment
