#include "jobs/scratch_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

#include "jobs/job.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "worker-";
constexpr mode_t kOwnerOnly = 0700;

// The descriptor of a folder that nobody else has locked, or -1.
int locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return -1;
  struct stat facts {};
  // One without links was removed by whoever held the lock before.
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &facts) == 0 &&
      facts.st_nlink > 0)
    return descriptor;
  ::close(descriptor);
  return -1;
}

void remove_abandoned(const fs::path& parent) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(parent, ignored))
    if (entry.path().filename().string().starts_with(kPrefix)) found.push_back(entry.path());
  for (const fs::path& one : found) {
    const int descriptor = locked(one);
    if (descriptor < 0) continue;
    fs::remove_all(one, ignored);
    ::close(descriptor);
  }
}

}  // namespace

ScratchFolder::ScratchFolder(const fs::path& parent) {
  std::error_code error;
  fs::create_directories(parent.parent_path(), error);
  if (::mkdir(parent.c_str(), kOwnerOnly) != 0 && errno != EEXIST) throw_write_error(parent, errno);
  remove_abandoned(parent);
  // Between the making and the lock another one may take it for abandoned.
  while (lock_ < 0) {
    path_ = parent / (kPrefix + new_job_id());
    if (::mkdir(path_.c_str(), kOwnerOnly) != 0) throw_write_error(path_, errno);
    lock_ = locked(path_);
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  ::close(lock_);
}

}  // namespace regarment
