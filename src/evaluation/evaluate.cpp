#include "evaluation/evaluate.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/stopwatch.h"
#include "evaluation/baseline.h"
#include "evaluation/estimates.h"
#include "evaluation/evaluation_folder.h"
#include "evaluation/evaluation_table.h"
#include "evaluation/fit_job.h"
#include "evaluation/gate.h"
#include "evaluation/scan_outcome.h"
#include "evaluation/sum_up.h"
#include "report/files.h"
#include "report/text.h"
#include "report/version.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostTableBytes = (16U << 20U) + 1;  // CsvTable refuses more
constexpr std::size_t kMostBaselineBytes = std::size_t{256} << 20U;

CsvTable read_table(const fs::path& file) {
  return CsvTable::parse(read_file(file, kMostTableBytes), file.filename().string());
}

// Tells how far the fits are.
class FitProgress {
 public:
  FitProgress(const Progress& progress, std::size_t scans) : progress_(progress), scans_(scans) {}

  void tell() const { progress_.report("fit", share(), line_); }

  // `fresh`: it took time now.
  void add(const EvaluatedScan& scan, bool fresh) {
    ++done_;
    if (fresh) ++fresh_;
    if (const auto error = scan.mean_error_cm()) sum_ += *error, ++measured_;
    line_ = "scan " + std::to_string(done_) + " of " + std::to_string(scans_);
    if (measured_ > 0) {
      line_ += ", mean error " + fixed_text(sum_ / static_cast<double>(measured_), 2) + " cm";
    }
    if (fresh_ > 0 && done_ < scans_) {
      const double each = watch_.total() / static_cast<double>(fresh_);
      line_ += ", " + duration_text(each * static_cast<double>(scans_ - done_)) + " left";
    }
    tell();
  }

 private:
  double share() const { return static_cast<double>(done_) / static_cast<double>(scans_); }

  const Progress& progress_;
  std::size_t scans_, done_ = 0, fresh_ = 0, measured_ = 0;
  double sum_ = 0;
  Stopwatch watch_;
  std::string line_;
};

std::vector<FitJob> make_jobs(const std::vector<EvaluationCase>& cases,
                              const EvaluateOptions& options, const fs::path& fits) {
  const FitJobOptions how{options.program,     options.table,   fits,
                          options.fit_options, options.threads, options.timing};
  const std::string program = file_sha256(options.program);
  std::vector<FitJob> jobs;
  for (const EvaluationCase& one : cases) {
    jobs.push_back(make_fit_job(one, how, program));
    if (!options.check_fit) continue;
    try {
      options.check_fit(jobs.back().command, one.garments);
    } catch (const UsageError& error) {
      throw UsageError("the fit of " + one.name + ": " + error.what());
    }
  }
  return jobs;
}

std::vector<EvaluatedScan> fit_all(const std::vector<EvaluationCase>& cases,
                                   const std::vector<FitJob>& jobs, const EvaluateOptions& options,
                                   const Progress& progress) {
  std::vector<EvaluatedScan> scans(cases.size());
  std::vector<std::size_t> to_do;
  FitProgress told(progress, cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (options.force || !is_finished(jobs[i], cases[i])) {
      to_do.push_back(i);
      continue;
    }
    scans[i] = finished_scan(cases[i], jobs[i].folder);
    told.add(scans[i], false);
  }
  std::vector<std::vector<std::string>> commands;
  for (const std::size_t i : to_do) {
    std::error_code ignored;
    fs::remove_all(jobs[i].folder, ignored);  // of other options or bytes
    commands.push_back(jobs[i].command);
  }
  const auto ended = [&](std::size_t k, const ChildEnd& end) {
    const std::size_t i = to_do[k];
    if (end.status == 0) mark_finished(jobs[i]);
    scans[i] = end.status == 0 ? finished_scan(cases[i], jobs[i].folder)
                               : failed_scan(cases[i], end, options.timeout);
    told.add(scans[i], true);
  };
  run_children(commands, {options.jobs, std::chrono::seconds(options.timeout)}, ended,
               [&] { told.tell(); });
  return scans;
}

}  // namespace

Evaluation evaluate(const EvaluateOptions& options, const Progress& progress) {
  std::vector<Gate> gates;
  for (const std::string& text : options.gates) gates.push_back(parse_gate(text));
  std::optional<Baseline> baseline;
  if (options.baseline) {
    baseline = parse_baseline(read_file(*options.baseline, kMostBaselineBytes),
                              options.baseline->filename().string());
  }
  const CsvTable table = read_table(options.table);
  const fs::path table_folder = options.table.parent_path();
  Evaluation out;
  out.version = version();
  out.table = table.name();
  out.fit_options = options.fit_options;
  out.timing = options.timing;
  if (options.estimates) {
    out.estimates = options.estimates->filename().string();
    out.scans = compare_estimates(table, table_folder, read_table(*options.estimates));
    check_gate_groups(gates, group_statistics(out.scans));
  }
  std::vector<EvaluationCase> cases;
  if (!options.estimates) {
    cases = read_evaluation_table(table, table_folder, options.scans, options.only);
    check_gate_groups(gates, expected_groups(cases));
  }
  const EvaluationFolder folder(options.out);
  if (!options.estimates) {
    const std::vector<FitJob> jobs = make_jobs(cases, options, folder.fits());
    out.scans = fit_all(cases, jobs, options, progress);
  }
  sum_up(out, gates, baseline, folder, progress);
  return out;
}

}  // namespace regarment
