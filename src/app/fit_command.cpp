#include <thread>
#include <utility>

#include "analysis/analyze.h"
#include "app/annealing_options.h"
#include "app/commands.h"
#include "base/one_line.h"
#include "base/stopwatch.h"
#include "garment/find_template.h"
#include "report/ground_truth.h"
#include "report/label_score.h"
#include "report/output_folder.h"
#include "report/report_folder.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

std::vector<GarmentTemplate> find_templates(const std::vector<std::string>& names) {
  std::vector<GarmentTemplate> out;
  out.reserve(names.size());
  for (const std::string& name : names) out.push_back(find_template(name));
  return out;
}

// Every file the result must not replace.
std::vector<fs::path> inputs_of(const FitArguments& a) {
  std::vector<fs::path> inputs = {a.scan};
  for (const auto& file : {a.placement, a.ground_truth, a.ground_truth_labels}) {
    if (file) inputs.push_back(*file);
  }
  return inputs;
}

// What the user chose away from the defaults, and what makes the same result again.
std::vector<std::pair<std::string, std::string>> chosen_options(const FitArguments& a) {
  std::vector<std::pair<std::string, std::string>> out;
  const auto add = [&](const std::string& name, const std::string& value) {
    if (value != "auto") out.emplace_back(name, value);
  };
  const auto add_file = [&](const std::string& name, const std::optional<fs::path>& file) {
    if (file) out.emplace_back(name, (a.timing ? *file : file->filename()).string());
  };
  add("units", a.units);
  add("up", a.up);
  add("front", a.front);
  if (a.method == "annealing") {
    for (auto& option : chosen_annealing(a.annealing)) out.push_back(std::move(option));
  }
  for (auto& option : chosen_known(a.known)) out.push_back(std::move(option));
  add_file("placement", a.placement);
  add_file("ground-truth", a.ground_truth);
  add_file("ground-truth-labels", a.ground_truth_labels);
  return out;
}

AnalyzeOptions analyze_options(const FitArguments& a, const std::vector<GarmentTemplate>& templates,
                               int threads) {
  AnalyzeOptions how;
  if (a.placement) how.placement = read_placement(*a.placement);
  if (a.method == "annealing") how.method = Method::Annealing;
  apply_annealing(a.annealing, how);
  how.fit.seed = a.seed;
  how.fit.threads = threads;
  apply_known(a.known, templates, how);
  return how;
}

ReportOptions report_options(const FitArguments& a, int threads) {
  ReportOptions options;
  options.seed = a.seed;
  options.options = chosen_options(a);
  options.scan_path = a.scan.string();
  options.threads = threads;
  options.timing = a.timing;
  return options;
}

int thread_count(const FitArguments& a) {
  if (a.threads > 0) return a.threads;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

Scan prepared(const ReadMesh& read, const FitArguments& a) {
  Scan scan = make_scan(read.mesh, {a.units, a.up, a.front});
  scan.facts.file = a.scan.filename().string();
  scan.facts.sha256 = read.sha256;
  return scan;
}

}  // namespace

void run_fit(const FitArguments& a, Console& console) {
  const std::vector<GarmentTemplate> templates = find_templates(a.garments);
  check_output_folder(a.out, a.force, inputs_of(a));
  std::vector<TruthRow> truth;
  if (a.ground_truth) truth = read_ground_truth(*a.ground_truth, a.scan);
  const int threads = thread_count(a);
  const AnalyzeOptions how = analyze_options(a, templates, threads);
  const Progress progress = console.progress();
  ReportOptions options = report_options(a, threads);

  Stopwatch watch;
  ReadMesh read = read_mesh_sandboxed(a.scan, {}, progress);
  std::vector<std::uint8_t> true_labels;
  if (a.ground_truth_labels) {
    true_labels = read_labels(*a.ground_truth_labels, read.mesh.positions.size());
  }
  const double read_seconds = watch.lap();

  progress.report("prepare", 0.0);
  Scan scan = prepared(read, a);
  read.mesh = {};
  progress.report("prepare", 1.0);
  const double prepare_seconds = watch.lap();

  Analysis analysis = analyze(std::move(scan), templates, how, progress);
  analysis.times.insert(analysis.times.begin(),
                        {{"read", read_seconds}, {"prepare", prepare_seconds}});
  if (!truth.empty()) apply_ground_truth(truth, a.ground_truth->filename().string(), analysis);
  if (!true_labels.empty()) {
    options.label_score = score_labels(analysis.labels, true_labels, analysis.garments.size());
  }
  const std::string result =
      write_report_folder(analysis, templates, options, a.out, a.force, progress);
  console.say(one_line((a.out / "report.html").string(), 4096));
  if (console.wants_json()) console.answer(result);
}

}  // namespace regarment
