#include "jobs/job_inputs.h"

#include <algorithm>

#include "base/error.h"
#include "jobs/batch_tables.h"
#include "jobs/file_names.h"
#include "jobs/job_store.h"

namespace regarment {

void prepare_inputs(const Job& job, const JobFolders& folders, JobStore& store) {
  if (job.kind == JobKind::Evaluate && !job.batch.empty()) write_batch_tables(job, folders, store);
}

std::vector<std::string> job_inputs(const Job& job, const JobFolders& folders, JobStore& store) {
  std::vector<std::string> out;
  const auto add = [&](const std::filesystem::path& folder, const std::string& name) {
    out.push_back(((folder / name).lexically_relative(folders.data() / "jobs")).string());
  };
  if (job.kind == JobKind::Refit) {
    const std::filesystem::path from = folders.result(source_of(job, store));
    for (const std::string& name : file_names(from))
      if (name == "state.bin" || name == "result.json") add(from, name);
    return out;
  }
  const std::filesystem::path folder = folders.job(job.id);
  for (const std::string& name : file_names(folder))
    if (!name.starts_with("result-")) add(folder, name);
  return out;
}

Job source_of(const Job& refit, JobStore& store) {
  const auto source = store.find(refit.source);
  if (!source || source->state != JobState::Succeeded) {
    throw UsageError(
        "the job whose result this one begins from has none, or is deleted; submit the "
        "scan again");
  }
  return *source;
}

}  // namespace regarment
