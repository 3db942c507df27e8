#include "app/check_arguments.h"

#include "app/evaluate_options.h"
#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

// A flag that was taken for a value: "--out --force".
void check_value(const std::string& option, const std::filesystem::path& value) {
  if (value.empty()) throw UsageError(option + ": the value is empty; give a path");
  if (value.string().starts_with("--")) {
    throw UsageError(option + ": '" + one_line(value.string(), 60) +
                     "' looks like an option; write ./" + one_line(value.string(), 60) +
                     " for a file of that name");
  }
}

void check_method(const std::string& method) {
  if (method == "direct" || method == "annealing" || method == "joint") return;
  throw UsageError("--method: '" + one_line(method, 60) +
                   "' is unknown; use --method joint, direct or annealing");
}

void check_name(const std::string& name) {
  constexpr std::size_t kLongest = 255;
  if (name.size() > kLongest || name == "." || name == ".." ||
      name.find_first_of(std::string_view("/\0", 2)) != std::string::npos) {
    throw UsageError("--name: '" + one_line(name, 60) +
                     "' is no file name; give one of at most 255 characters, without '/'");
  }
}

}  // namespace

void check(const FitArguments& a) {
  check_method(a.method);
  check_value("SCAN", a.scan);
  check_name(a.name);
  check_value("--out", a.out);
  for (const std::string& garment : a.garments) check_value("--garment", garment);
  if (a.garments.size() > 8) throw UsageError("--garment: more than 8 layers; give fewer");
  check_known(a.known);
  if (a.placement) check_value("--placement", *a.placement);
  if (a.cache) check_value("--cache", *a.cache);
  if (a.ground_truth) check_value("--ground-truth", *a.ground_truth);
  if (a.ground_truth_labels) check_value("--ground-truth-labels", *a.ground_truth_labels);
  if (a.up != "auto" && a.front != "auto" && a.up.back() == a.front.back()) {
    throw UsageError("--up " + a.up + " --front " + a.front + ": both along one axis; change one");
  }
}

void check(const RefitArguments& a) {
  check_value("DIR", a.folder);
  if (a.out) check_value("--out", *a.out);
  if (!a.out && !a.force)
    throw UsageError("refit: give --out FOLDER, or --force to replace the result in DIR");
  if (a.method) check_method(*a.method);
  check_known(a.known);
}

void check(const EvaluateArguments& a) {
  check_value("TABLE", a.table);
  check_value("--out", a.out);
  if (a.scans) check_value("--scans", *a.scans);
  if (a.estimates) check_value("--estimates", *a.estimates);
  if (a.baseline) check_value("--baseline", *a.baseline);
  check_evaluate_options(a);
}

void check(const BatchArguments& a) {
  if (a.table) check_value("TABLE", *a.table);
  if (a.out) check_value("--out", *a.out);
  if (a.scans) check_value("--scans", *a.scans);
  if (a.status) check_value("--status", *a.status);
  check_batch(a);
}

void check(const BatchTaskArguments& a) {
  check_value("DIR", a.folder);
  check_batch_task(a);
}

void check(const SynthesizeArguments& a) {
  check_value("--out", a.out);
  for (const std::string& garment : a.garments) check_value("--garment", garment);
}

void check(const ReportArguments& a) { check_value("DIR", a.folder); }

void check(const ReviewArguments& a) {
  check_value("--out", a.out);
  for (const auto& folder : a.folders) check_value("DIR", folder);
}

void check(const RenderArguments& a) {
  check_value("--out", a.out);
  for (const auto& mesh : a.meshes) check_value("MESH", mesh);
  if (a.meshes.size() > 1000) throw UsageError("MESH: more than 1000 files; give fewer");
}

}  // namespace regarment
