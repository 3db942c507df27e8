#include "jobs/batch_tables.h"

#include <set>

#include "base/error.h"
#include "jobs/job_store.h"
#include "report/csv_table.h"
#include "report/files.h"
#include "report/result.h"
#include "report/text.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostResult = 16U << 20U;
constexpr int kDigits = 6;  // of a centimetre: more than any tape has
constexpr int kPage = 500;

constexpr const char* kResultColumns =
    "scan,layer,template,measurement,value_cm,low_cm,high_cm,worn_cm,observable,report\n";
constexpr const char* kTruthColumns =
    "scan,layer,template,measurement,value_cm,published_cm,tol_minus_cm,tol_plus_cm\n";

std::string cm(const std::optional<double>& value) {
  return value ? fixed_text(*value, kDigits) : "";
}

std::string line_of(std::initializer_list<std::string> cells) {
  std::string out;
  for (const std::string& cell : cells) out.append(out.empty() ? "" : ",").append(cell);
  return out + "\n";
}

// Newest first, one of each name.
std::vector<Job> counted_jobs(const std::string& batch, JobStore& store) {
  std::vector<Job> out;
  std::set<std::string> names;
  JobFilter filter{.states = {JobState::Succeeded}, .batch = batch, .limit = kPage};
  do {
    JobPage page = store.list(filter);
    for (Job& job : page.jobs) {
      const bool fits = job.kind == JobKind::Fit || job.kind == JobKind::Refit;
      if (fits && names.insert(job.name).second) out.push_back(std::move(job));
    }
    filter.after = page.next;
  } while (!filter.after.empty());
  return out;
}

void add_result(const Job& job, const Result& result, std::string& results, std::string& truth) {
  const std::string scan = csv_exact(job.name), report = "/v1/jobs/" + job.id + "/report";
  for (const ResultGarment& garment : result.garments) {
    const std::string layer = std::to_string(garment.layer),
                      type = csv_exact(garment.template_name);
    for (const ResultMeasurement& m : garment.measurements) {
      results += line_of({scan, layer, type, csv_exact(m.name), cm(m.value_cm), cm(m.low_cm),
                          cm(m.high_cm), cm(m.worn_cm), m.observable ? "true" : "false", report});
      if (m.truth_cm)
        truth += line_of({scan, layer, type, csv_exact(m.name), cm(m.truth_cm), cm(m.published_cm),
                          cm(m.tol_minus_cm), cm(m.tol_plus_cm)});
    }
  }
}

}  // namespace

BatchTables write_batch_tables(const Job& job, const JobFolders& folders, JobStore& store) {
  std::string results = kResultColumns, truth = kTruthColumns;
  const std::size_t nothing = results.size(), no_truth = truth.size();
  for (const Job& one : counted_jobs(job.batch, store)) {
    try {
      const fs::path file = folders.result(one) / "result.json";
      add_result(one, parse_result(read_file(file, kMostResult), "result.json"), results, truth);
    } catch (const ReadError&) {
      // Deleted since it was listed.
    }
  }
  if (results.size() == nothing)
    throw UsageError("no fit of the batch has a result; evaluate it once one has");
  BatchTables tables = batch_tables(job, folders);
  std::error_code ignored;
  fs::create_directory(tables.results.parent_path(), ignored);
  replace_file(tables.results, results);
  if (tables.truth.parent_path() != tables.results.parent_path()) return tables;
  if (truth.size() == no_truth)
    throw UsageError("no scan of the batch came with its true sizes; send a table of them");
  replace_file(tables.truth, truth);
  return tables;
}

BatchTables batch_tables(const Job& job, const JobFolders& folders) {
  const fs::path folder = folders.job(job.id), sent = folder / "truth.csv";
  const fs::path tables = folder / "tables";
  std::error_code ignored;
  return {fs::is_regular_file(sent, ignored) ? sent : tables / "truth.csv", tables / "results.csv"};
}

}  // namespace regarment
