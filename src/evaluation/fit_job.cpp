#include "evaluation/fit_job.h"

#include "base/error.h"
#include "report/files.h"
#include "report/result.h"
#include "report/version.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKeyFile = "evaluation.key";
constexpr std::size_t kMostResultBytes = 64U << 20U;

// A path that cannot be taken for an option.
std::string path_argument(const fs::path& path) {
  const std::string text = path.string();
  return text.starts_with("-") ? "./" + text : text;
}

// A word that names a file, such as a placement or a template, stands for the file's bytes.
void add_word(const char* what, const std::string& word, std::string& key) {
  key.append(what).append(" ").append(word);
  std::error_code ignored;
  if (fs::is_regular_file(word, ignored)) key.append(" ").append(file_sha256(word));
  key += "\n";
}

std::string key_of(const EvaluationCase& one, const FitJobOptions& options,
                   const std::string& program_sha256) {
  std::string key = "regarment " + version() + " " + program_sha256 + "\n";
  for (const std::string& garment : one.garments) add_word("garment", garment, key);
  for (const std::string& word : options.options) add_word("option", word, key);
  for (const std::string& word : one.options) add_word("option of its own", word, key);
  if (!options.timing) key += "no timing\n";
  key += one.truth_rows;
  if (one.labels) key += "labels " + file_sha256(*one.labels) + "\n";
  return key;
}

}  // namespace

std::vector<std::string> fit_words(const EvaluationCase& one, const FitJobOptions& options) {
  std::vector<std::string> words = {path_argument(one.scan)};
  const auto add = [&](const std::string& name, const std::string& value) {
    words.push_back(name), words.push_back(value);
  };
  for (const std::string& garment : one.garments) add("--garment", garment);
  words.insert(words.end(), {"--quiet", "--no-state"});
  add("--threads", std::to_string(options.threads));
  if (!options.timing) words.push_back("--no-timing");
  if (!one.dimensions.empty()) add("--ground-truth", path_argument(options.table));
  if (one.labels) add("--ground-truth-labels", path_argument(*one.labels));
  words.insert(words.end(), options.options.begin(), options.options.end());
  words.insert(words.end(), one.options.begin(), one.options.end());
  return words;
}

FitJob make_fit_job(const EvaluationCase& one, const FitJobOptions& options,
                    const std::string& program_sha256) {
  FitJob job;
  job.folder = options.fits / one.name;
  job.key = key_of(one, options, program_sha256);
  job.command = fit_words(one, options);
  job.command.insert(job.command.begin(), {options.program.string(), "fit"});
  job.command.insert(job.command.end(), {"--out", path_argument(job.folder), "--force"});
  return job;
}

bool is_finished(const FitJob& job, const EvaluationCase& one) {
  try {
    if (read_file(job.folder / kKeyFile, job.key.size() + 1) != job.key) return false;
    const std::string text = read_file(job.folder / "result.json", kMostResultBytes);
    return parse_result(text, "result.json").scan.sha256 == file_sha256(one.scan);
  } catch (const ReadError&) {
    return false;
  }
}

void mark_finished(const FitJob& job) { write_file(job.folder / kKeyFile, job.key); }

}  // namespace regarment
