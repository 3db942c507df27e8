#include <utility>

#include "app/commands.h"
#include "app/finish_fit.h"
#include "base/error.h"
#include "base/one_line.h"
#include "base/stopwatch.h"
#include "geometry/parallel.h"
#include "report/files.h"
#include "report/output_folder.h"
#include "report/result.h"
#include "scan/file_bytes.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostJson = 64U << 20U;  // bytes
constexpr std::uintmax_t kMostState = std::uintmax_t{4} << 30U;

Result stored_result(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw UsageError(one_line(folder.string(), 300) +
                     ": is no folder; give one that 'regarment fit' wrote");
  }
  return parse_result(read_file(folder / "result.json", kMostJson), "result.json");
}

// The command of a stored result as arguments. What they name is checked as if it were typed.
FitArguments arguments_of(const Result& result) {
  std::vector<std::string> words = {"regarment", "fit", "scan", "--out", "out"};
  for (const ResultGarment& garment : result.garments) {
    words.insert(words.end(), {"--garment", garment.template_name});
  }
  words.insert(words.end(), {"--method", result.method, "--seed", std::to_string(result.seed)});
  for (const auto& [name, value] : result.options) {
    words.push_back("--" + name);
    if (!value.empty()) words.push_back(value);
  }
  std::vector<const char*> texts;
  texts.reserve(words.size());
  for (const std::string& word : words) texts.push_back(word.c_str());
  try {
    const Command command = parse_command_line(static_cast<int>(texts.size()), texts.data());
    if (const auto* fit = std::get_if<FitArguments>(&command)) return *fit;
  } catch (const UsageError& error) {
    throw ReadError(std::string("result.json: its options cannot be taken over: ") + error.what());
  }
  throw ReadError("result.json: its options are none of a fit; run 'regarment fit' again");
}

FitArguments changed(FitArguments fit, const Result& result, const RefitArguments& a) {
  fit.speech = a.speech;
  fit.scan = result.scan.path.value_or(result.scan.file);
  fit.out = a.out.value_or(a.folder);
  fit.force = a.force, fit.timing = a.timing, fit.state = a.state, fit.threads = a.threads;
  if (a.method) fit.method = *a.method;
  fit.known = a.forget ? a.known : more_known(fit.known, a.known);
  return fit;
}

FitMaterial stored_material(const fs::path& folder, const Result& result) {
  FitMaterial out;
  out.refit = true;
  Stopwatch watch;
  const fs::path file = folder / "state.bin";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw ReadError(one_line(file.string(), 300) +
                    ": is not there; run 'regarment fit' again, without --no-state");
  }
  const FileBytes bytes = read_file_bytes(file, kMostState);
  out.stored.resize(bytes.size);
  std::copy_n(reinterpret_cast<const char*>(bytes.data.get()), bytes.size, out.stored.data());
  out.state = read_state(out.stored, "state.bin");
  if (out.state.scan.facts.sha256 != result.scan.sha256) {
    throw ReadError("state.bin: is of another scan than result.json; run 'regarment fit' again");
  }
  out.times.push_back({"state", watch.lap()});
  return out;
}

// The truth stands in the result; its table need not be there any more.
void carry_truth(const Result& result, Analysis& analysis) {
  const auto metres = [](const std::optional<double>& cm) {
    return cm ? std::optional<double>(*cm / 100) : std::nullopt;
  };
  for (std::size_t g = 0; g < result.garments.size(); ++g) {
    for (const ResultMeasurement& known : result.garments[g].measurements) {
      for (Measurement& m : analysis.garments.at(g).measurements) {
        if (m.name != known.name) continue;
        m.truth = metres(known.truth_cm), m.published = metres(known.published_cm);
        m.tol_minus = metres(known.tol_minus_cm), m.tol_plus = metres(known.tol_plus_cm);
      }
    }
  }
}

}  // namespace

void run_refit(const RefitArguments& a, Console& console) {
  const Result result = stored_result(a.folder);
  const FitArguments fit = changed(arguments_of(result), result, a);
  limit_threads(thread_count(fit));
  const std::vector<GarmentTemplate> templates = templates_of(fit);
  check_output_folder(fit.out, fit.force);
  const AnalyzeOptions how = analyze_options(fit, templates);
  FitMaterial material = stored_material(a.folder, result);
  finish_fit(
      fit, templates, how, std::move(material),
      [&](Analysis& analysis) { carry_truth(result, analysis); }, console);
}

}  // namespace regarment
