#include <utility>

#include "app/commands.h"
#include "app/finish_fit.h"
#include "base/stopwatch.h"
#include "report/ground_truth.h"
#include "report/label_score.h"
#include "report/output_folder.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"

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

Scan prepared(const ReadMesh& read, const FitArguments& a) {
  Scan scan = make_scan(read.mesh, {a.units, a.up, a.front});
  scan.facts.file = a.scan.filename().string();
  scan.facts.sha256 = read.sha256;
  return scan;
}

// Reads the scan and prepares it, by way of the state, so that a refit works on the same numbers.
FitMaterial read_material(const FitArguments& a, const Progress& progress) {
  FitMaterial out;
  if (a.placement) out.state.placement = read_placement(*a.placement);
  Stopwatch watch;
  ReadMesh read = read_mesh_sandboxed(a.scan, {}, progress);
  if (a.ground_truth_labels) {
    out.state.true_labels = read_labels(*a.ground_truth_labels, read.mesh.positions.size());
  }
  out.times.push_back({"read", watch.lap()});
  progress.report("prepare", 0.0);
  out.state.scan = prepared(read, a);
  read.mesh = {};
  out.stored = write_state(out.state);
  out.state = read_state(out.stored, "the prepared scan");
  progress.report("prepare", 1.0);
  out.times.push_back({"prepare", watch.lap()});
  return out;
}

}  // namespace

void run_fit(const FitArguments& a, Console& console) {
  const std::vector<GarmentTemplate> templates = templates_of(a);
  check_output_folder(a.out, a.force, inputs_of(a));
  std::vector<TruthRow> truth;
  if (a.ground_truth) truth = read_ground_truth(*a.ground_truth, a.scan);
  const AnalyzeOptions how = analyze_options(a, templates);
  const auto add_truth = [&](Analysis& analysis) {
    if (!truth.empty()) apply_ground_truth(truth, a.ground_truth->filename().string(), analysis);
  };
  FitMaterial material = read_material(a, console.progress());
  finish_fit(a, templates, how, std::move(material), add_truth, console);
}

}  // namespace regarment
