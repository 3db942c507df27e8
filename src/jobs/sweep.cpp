#include "jobs/sweep.h"

#include <sys/stat.h>

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr int kMostJobs = 1000;
constexpr std::chrono::hours kAbandoned{24};

int delete_expired(JobStore& store, const JobFolders& folders, JobTime before) {
  int deleted = 0;
  for (const std::string& id : store.ended_before(before, kMostJobs)) {
    if (!store.remove(id)) continue;
    folders.remove(id);
    ++deleted;
  }
  return deleted;
}

// When something was last added to or taken from the folder.
JobTime changed(const fs::path& folder) {
  struct stat facts {};
  ::stat(folder.c_str(), &facts);
  return JobTime(std::chrono::seconds(facts.st_mtime));
}

// A job between its folder and its row is young: an upload takes no day.
bool is_abandoned(JobStore& store, const fs::path& folder, JobTime now) {
  const std::string name = folder.filename().string();
  if (name.starts_with("removed-")) return true;
  if (const auto claim = JobFolders::claim_of_delivery(name)) {
    const auto job = store.find(claim->first);
    return !job || !job->is_held_under(claim->second);
  }
  return is_job_id(name) && changed(folder) + kAbandoned <= now && !store.find(name);
}

}  // namespace

Swept sweep_data(JobStore& store, const JobFolders& folders, std::chrono::milliseconds keep,
                 JobTime now) {
  Swept swept;
  if (keep.count() > 0) swept.expired = delete_expired(store, folders, now - keep);
  for (const char* place : {"incoming", "jobs"}) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folders.data() / place, ignored)) {
      found.push_back(entry.path());
    }
    for (const fs::path& one : found) {
      if (!is_abandoned(store, one, now)) continue;
      fs::remove_all(one, ignored);
      ++swept.abandoned;
    }
  }
  return swept;
}

}  // namespace regarment
