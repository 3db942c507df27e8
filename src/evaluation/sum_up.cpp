#include "evaluation/sum_up.h"

#include "base/error.h"
#include "evaluation/confusion_picture.h"
#include "evaluation/evaluation_csv.h"
#include "evaluation/evaluation_json.h"
#include "evaluation/evaluation_page.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// Of the scans the page shows first, as far as they have true labels.
void draw_worst(Evaluation& evaluation, const fs::path& fits, const Progress& progress) {
  const std::vector<std::size_t> worst = worst_scans(evaluation);
  for (std::size_t k = 0; k < worst.size(); ++k) {
    const EvaluatedScan& scan = evaluation.scans[worst[k]];
    progress.report("draw", static_cast<double>(k) / static_cast<double>(worst.size()));
    if (!scan.labels) continue;
    try {
      DrawnConfusion drawn = draw_confusion(scan.about, fits / scan.about.name);
      evaluation.pictures.push_back({worst[k], std::move(drawn.webp), drawn.width, drawn.height});
    } catch (const NoPersonError&) {
      // Standing only by its own options, such as --front; the page goes without this picture.
    }
  }
  progress.report("draw", 1);
}

}  // namespace

std::vector<GroupStatistics> expected_groups(const std::vector<EvaluationCase>& cases) {
  std::vector<EvaluatedScan> scans;
  for (const EvaluationCase& one : cases) {
    scans.emplace_back();
    scans.back().about = one;
  }
  return group_statistics(scans);
}

void sum_up(Evaluation& evaluation, const std::vector<Gate>& gates,
            const std::optional<Baseline>& baseline, const EvaluationFolder& folder,
            const Progress& progress) {
  evaluation.groups = group_statistics(evaluation.scans);
  if (!evaluation.estimates) draw_worst(evaluation, folder.fits(), progress);
  evaluation.gates = judge(gates, evaluation.groups);
  if (baseline) evaluation.baseline = compare_with(*baseline, evaluation);
  folder.write("evaluation.csv", evaluation_csv(evaluation));
  folder.write("evaluation.html", evaluation_page(evaluation));
  folder.write("evaluation.json", evaluation_json(evaluation));
}

}  // namespace regarment
