#include "evaluation/evaluation_csv.h"

#include "report/csv_table.h"
#include "report/text.h"

namespace regarment {
namespace {

std::string number(const std::optional<double>& value) {
  return value ? fixed_text(*value, 3) : "";
}

std::string yes_no(const std::optional<bool>& value) {
  return value ? (*value ? "true" : "false") : "";
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ";") + word;
  return out;
}

std::string row_of(const EvaluatedScan& scan, std::size_t d) {
  const TrueDimension& truth = scan.about.dimensions[d];
  const FoundDimension* found = d < scan.found.size() && scan.found[d] ? &*scan.found[d] : nullptr;
  const auto of = [&](auto value) -> decltype(value(*found)) {
    return found != nullptr ? value(*found) : decltype(value(*found))();
  };
  using Number = std::optional<double>;
  const std::vector<std::string> cells = {
      csv_text(scan.about.name),
      csv_text(scan.about.scan.filename().string()),
      csv_text(scan.about.garment),
      csv_text(scan.about.kind),
      csv_text(joined(scan.about.damage)),
      std::to_string(truth.layer),
      csv_text(truth.template_name),
      csv_text(truth.measurement),
      number(truth.truth_cm),
      number(of([](const FoundDimension& f) { return Number(f.value_cm); })),
      number(of([](const FoundDimension& f) { return f.low_cm; })),
      number(of([](const FoundDimension& f) { return f.high_cm; })),
      number(of([&](const FoundDimension& f) { return Number(f.value_cm - truth.truth_cm); })),
      yes_no(of([](const FoundDimension& f) { return std::optional(f.observable); })),
      yes_no(truth.observable),
      number(of([](const FoundDimension& f) { return f.worn_cm; })),
      number(truth.worn_cm),
      number(truth.published_cm),
      csv_text(scan.failure ? scan.failure->kind : "")};
  std::string out;
  for (const std::string& cell : cells) out += (out.empty() ? "" : ",") + cell;
  return out + "\n";
}

}  // namespace

std::string evaluation_csv(const Evaluation& evaluation) {
  std::string out =
      "scan,file,garment,kind,damage,layer,template,measurement,truth_cm,estimate_cm,low_cm,high_"
      "cm,"
      "error_cm,observable,truth_observable,worn_cm,worn_truth_cm,published_cm,failure\n";
  for (const EvaluatedScan& scan : evaluation.scans) {
    for (std::size_t d = 0; d < scan.about.dimensions.size(); ++d) out += row_of(scan, d);
  }
  return out;
}

}  // namespace regarment
