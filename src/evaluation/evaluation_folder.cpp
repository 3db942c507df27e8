#include "evaluation/evaluation_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

#include "base/error.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = {ENOTDIR, std::generic_category()};
  if (error) throw_write_error(folder, error.value());
}

bool may_be_used(const fs::path& place) {
  std::error_code error;
  const bool empty = fs::is_empty(place, error);
  return empty || fs::is_directory(place / "fits", error) ||
         fs::is_regular_file(place / "evaluation.json", error);
}

// Where a fit was stopped with force while it wrote (see report/output_folder.h).
void remove_half_written(const fs::path& fits) {
  std::vector<fs::path> stale;
  std::error_code error;
  for (fs::directory_iterator i(fits, error), end; !error && i != end; i.increment(error)) {
    if (i->path().filename().string().starts_with(".regarment-")) stale.push_back(i->path());
  }
  for (const fs::path& path : stale) fs::remove_all(path, error);
}

}  // namespace

EvaluationFolder::EvaluationFolder(fs::path place) : place_(std::move(place)) {
  make_folder(place_);
  if (!may_be_used(place_)) {
    throw UsageError(place_.string() +
                     ": is not empty and holds no evaluation; choose another --out");
  }
  lock_ = ::open(place_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw_write_error(place_, errno);
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    throw UsageError(place_.string() +
                     ": another evaluation is at work there; wait or choose another --out");
  }
  try {
    make_folder(fits());
    if (::access(place_.c_str(), W_OK) != 0) throw_write_error(place_, errno);
    remove_half_written(fits());
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

EvaluationFolder::~EvaluationFolder() { ::close(lock_); }

void EvaluationFolder::write(const std::string& name, std::string_view bytes) const {
  replace_file(place_ / name, bytes);
}

}  // namespace regarment
