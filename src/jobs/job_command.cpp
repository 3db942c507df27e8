#include "jobs/job_command.h"

#include <initializer_list>

#include "base/error.h"
#include "jobs/batch_tables.h"
#include "jobs/job_inputs.h"
#include "jobs/job_options.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 200;

using Words = std::vector<std::string>;

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

void add(Words& words, const std::string& option, const std::string& value) {
  words.push_back(option + "=" + value);
}

void add_fit(const Job& job, const JobFolders& folders, Words& words) {
  words.push_back(folders.scan(job.id));
  for (const std::string& garment : job.garments) add(words, "--garment", garment);
  const std::string name = scan_name_of(job.name);
  if (!name.empty()) add(words, "--name", name);
  const fs::path folder = folders.job(job.id);
  if (is_file(folder / "truth.csv")) add(words, "--ground-truth", folder / "truth.csv");
  if (is_file(folder / "labels.u8")) add(words, "--ground-truth-labels", folder / "labels.u8");
}

void add_evaluate(const Job& job, const JobFolders& folders, Words& words) {
  const fs::path folder = folders.job(job.id);
  if (!job.batch.empty()) {
    const BatchTables tables = batch_tables(job, folders);
    words.push_back(tables.truth);
    return add(words, "--estimates", tables.results);
  }
  if (!is_file(folder / "truth.csv")) {
    throw ReadError("the evaluation has no table in its folder; send the table again");
  }
  words.push_back(folder / "truth.csv");
  add(words, "--scans", folder / "scans");
  add(words, "--jobs", "1");
}

}  // namespace

std::string scan_name_of(const std::string& name) {
  std::string out = fs::path(name).filename().string().substr(0, kLongestName);
  return out == "." || out == ".." ? "" : out;
}

std::vector<std::string> job_command(const Job& job, const JobFolders& folders, JobStore& store,
                                     const fs::path& program, int threads) {
  Words words = {program, std::string(name_of(job.kind))};
  switch (job.kind) {
    case JobKind::Fit:
      add_fit(job, folders, words);
      break;
    case JobKind::Refit:
      words.push_back(folders.result(source_of(job, store)));
      break;
    case JobKind::Render:
      words.push_back(folders.scan(job.id));
      break;
    case JobKind::Evaluate:
      add_evaluate(job, folders, words);
      break;
  }
  add(words, "--out", folders.result(job));
  add(words, "--progress", "json");
  if (job.kind != JobKind::Render) add(words, "--threads", std::to_string(threads));
  const Words options = option_words(job.options);
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

}  // namespace regarment
