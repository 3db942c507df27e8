#include <optional>
#include <utility>

#include "app/commands.h"
#include "app/finish_fit.h"
#include "app/prepared_scan.h"
#include "base/stopwatch.h"
#include "geometry/parallel.h"
#include "report/ground_truth.h"
#include "report/label_score.h"
#include "report/output_folder.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// Every file the result must not replace.
std::vector<fs::path> inputs_of(const FitArguments& a) {
  std::vector<fs::path> inputs = {a.scan};
  for (const auto& file : {a.placement, a.ground_truth, a.ground_truth_labels}) {
    if (file) inputs.push_back(*file);
  }
  return inputs;
}

// Reads the scan and prepares it, by way of the state, so that a refit works on the same numbers.
FitMaterial read_material(const FitArguments& a, const Progress& progress) {
  FitMaterial out;
  if (a.placement) out.state.placement = read_placement(*a.placement);
  std::optional<StageCache> cache;
  if (a.cache) cache.emplace(*a.cache, std::uint64_t{1'000'000} * a.cache_mb);
  Stopwatch watch;
  PreparedScan prepared =
      prepared_scan(a, cache ? &*cache : nullptr, progress, [&](const char* stage) {
        out.times.push_back({stage, watch.lap()});
      });
  out.state.scan = std::move(prepared.scan);
  if (a.ground_truth_labels) {
    out.state.true_labels =
        read_labels(*a.ground_truth_labels, out.state.scan.mesh.positions.size());
  }
  const bool alone = !a.placement && !a.ground_truth_labels;
  out.stored = alone ? std::move(prepared.stored) : write_state(out.state);
  return out;
}

}  // namespace

void run_fit(const FitArguments& a, Console& console) {
  limit_threads(thread_count(a));
  const std::vector<GarmentTemplate> templates = templates_of(a);
  check_output_folder(a.out, a.force, inputs_of(a));
  std::vector<TruthRow> truth;
  if (a.ground_truth)
    truth = read_ground_truth(*a.ground_truth, a.scan.parent_path() / name_of_scan(a));
  const AnalyzeOptions how = analyze_options(a, templates);
  const auto add_truth = [&](Analysis& analysis) {
    if (!truth.empty()) apply_ground_truth(truth, a.ground_truth->filename().string(), analysis);
  };
  FitMaterial material = read_material(a, console.progress());
  finish_fit(a, templates, how, std::move(material), add_truth, console);
}

}  // namespace regarment
