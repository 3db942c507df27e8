#include "app/finish_fit.h"

#include <algorithm>
#include <map>
#include <thread>
#include <utility>

#include "app/annealing_options.h"
#include "base/one_line.h"
#include "garment/find_template.h"
#include "report/label_score.h"
#include "report/report_folder.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

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
  if (a.pixel_ratio != 1) add("pixel-ratio", std::to_string(a.pixel_ratio));
  add_file("placement", a.placement);
  add_file("ground-truth", a.ground_truth);
  add_file("ground-truth-labels", a.ground_truth_labels);
  return out;
}

// Every option with the value it had, chosen or not.
std::vector<std::pair<std::string, std::string>> every_option(const FitArguments& a) {
  std::vector<std::pair<std::string, std::string>> out = {
      {"method", a.method}, {"seed", std::to_string(a.seed)},
      {"units", a.units},   {"up", a.up},
      {"front", a.front},   {"pixel-ratio", std::to_string(a.pixel_ratio)}};
  const std::map<std::string, std::string> none = {
      {"fix", "none"},       {"hint", "none"},         {"fabric", "not said"},
      {"placement", "none"}, {"ground-truth", "none"}, {"ground-truth-labels", "none"}};
  const auto chosen = chosen_options(a);
  for (const auto& fallback : none) {
    const auto given = std::find_if(chosen.begin(), chosen.end(), [&](const auto& option) {
      return option.first == fallback.first;
    });
    out.emplace_back(fallback.first, given == chosen.end() ? fallback.second : given->second);
  }
  if (a.method == "annealing")
    for (auto& option : every_annealing(a.annealing)) out.push_back(std::move(option));
  return out;
}

}  // namespace

int thread_count(const FitArguments& a) {
  if (a.threads > 0) return a.threads;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

namespace {

ReportOptions report_options(const FitArguments& a) {
  ReportOptions options;
  options.seed = a.seed;
  options.options = chosen_options(a);
  options.settings = every_option(a);
  options.scan_path = a.scan.string();
  options.threads = thread_count(a);
  options.timing = a.timing;
  options.pixel_ratio = a.pixel_ratio;
  return options;
}

}  // namespace

std::vector<GarmentTemplate> templates_of(const FitArguments& a) {
  std::vector<GarmentTemplate> out;
  out.reserve(a.garments.size());
  for (const std::string& name : a.garments) out.push_back(find_template(name));
  return out;
}

AnalyzeOptions analyze_options(const FitArguments& a,
                               const std::vector<GarmentTemplate>& templates) {
  AnalyzeOptions how;
  if (a.method == "annealing") how.method = Method::Annealing;
  if (a.method == "joint") how.method = Method::Joint;
  apply_annealing(a.annealing, how);
  how.fit.seed = a.seed;
  how.fit.threads = thread_count(a);
  apply_known(a.known, templates, how);
  return how;
}

void finish_fit(const FitArguments& a, const std::vector<GarmentTemplate>& templates,
                AnalyzeOptions how, FitMaterial material,
                const std::function<void(Analysis&)>& add_truth, Console& console) {
  const Progress progress = console.progress();
  ReportOptions options = report_options(a);
  options.refit = material.refit;
  if (a.state) options.state = std::move(material.stored);
  // A height given by --hint counts more than the placement file's.
  PlacementOverrides placement = std::move(material.state.placement);
  for (const auto& [edge, height] : how.placement.edges) placement.edges[edge] = height;
  how.placement = std::move(placement);

  Analysis analysis = analyze(std::move(material.state.scan), templates, how, progress);
  analysis.times.insert(analysis.times.begin(), material.times.begin(), material.times.end());
  add_truth(analysis);
  const std::vector<std::uint8_t>& labels = material.state.true_labels;
  if (!labels.empty()) {
    options.label_score = score_labels(analysis.labels, labels, analysis.garments.size());
  }
  const std::string result =
      write_report_folder(analysis, templates, options, a.out, a.force, progress);
  console.say(one_line((a.out / "report.html").string(), 4096));
  if (console.wants_json()) console.answer(result);
}

}  // namespace regarment
