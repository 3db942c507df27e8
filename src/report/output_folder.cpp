#include "report/output_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "base/error.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& folder, const fs::path& inner) {
  const fs::path relative = fs::weakly_canonical(inner).lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

// Where a full folder may be replaced: --force must not take more than an earlier result.
void check_replaceable(const fs::path& place, const std::vector<fs::path>& inputs) {
  std::error_code ignored;
  const fs::path here = fs::current_path(ignored);
  const bool holds_input = std::any_of(inputs.begin(), inputs.end(), [&](const fs::path& input) {
    return holds(place, fs::absolute(input));
  });
  if (place == place.root_path() || holds(place, here) || holds_input) {
    throw UsageError(place.string() +
                     ": holds the working directory or the input and is not replaced; choose "
                     "another --out");
  }
}

void check_place(const fs::path& place, bool replace, const std::vector<fs::path>& inputs) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(place, error);
  if (status.type() == fs::file_type::not_found) return;
  if (status.type() != fs::file_type::directory) {
    throw UsageError(place.string() + ": is there and is no folder; choose another --out");
  }
  const bool empty = fs::is_empty(place, error);
  if (error) throw_write_error(place, error.value());
  if (empty) return;
  if (!replace) {
    throw UsageError(place.string() + ": is there and not empty; choose another --out or --force");
  }
  check_replaceable(place, inputs);
}

fs::path resolved(const fs::path& place) {
  if (place.empty()) throw UsageError("--out: the name is empty; give a folder");
  std::error_code error;
  fs::path absolute = fs::absolute(place, error).lexically_normal();
  if (!absolute.has_filename()) absolute = absolute.parent_path();
  if (error) throw_write_error(place, error.value());
  std::error_code ignored;
  if (!fs::is_symlink(absolute, ignored)) return absolute;
  absolute = fs::weakly_canonical(absolute, error);
  if (error) throw_write_error(place, error.value());
  return absolute;
}

// mkdtemp makes folders for the owner alone; results follow the user's umask like other files.
void open_to_umask(const fs::path& folder) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::chmod(folder.c_str(), 0777 & ~mask);
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& place, bool replace, const std::vector<fs::path>& inputs)
    : place_(resolved(place)), replace_(replace) {
  check_place(place_, replace, inputs);
  make_parents(place_.parent_path());
  std::string name = (place_.parent_path() / ".regarment-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    const int error = errno;
    remove_parents();
    throw_write_error(place, error);
  }
  hidden_ = name;
  open_to_umask(hidden_);
}

void OutputFolder::make_parents(const fs::path& parent) {
  std::error_code error;
  if (fs::is_directory(parent, error)) return;
  if (parent.has_relative_path()) make_parents(parent.parent_path());
  if (fs::create_directory(parent, error)) made_.push_back(parent);
  if (!error && !fs::is_directory(parent, error)) error = {ENOTDIR, std::generic_category()};
  if (!error) return;
  remove_parents();
  throw_write_error(parent, error.value());
}

// Only while they are empty: something else may have come to stand there meanwhile.
void OutputFolder::remove_parents() {
  std::error_code ignored;
  for (; !made_.empty(); made_.pop_back()) fs::remove(made_.back(), ignored);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!hidden_.empty()) fs::remove_all(hidden_, ignored);
  remove_parents();
}

void OutputFolder::write(const fs::path& name, std::string_view bytes) {
  const fs::path file = hidden_ / name;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw_write_error(place_ / name, error.value());
  write_file(file, bytes);
}

void OutputFolder::publish() {
  if (::rename(hidden_.c_str(), place_.c_str()) == 0) {
    hidden_.clear();
  } else if (errno != ENOTEMPTY && errno != EEXIST) {
    throw_write_error(place_, errno);
  } else if (!replace_) {
    throw UsageError(place_.string() + ": was filled meanwhile; choose another --out");
  } else {
    exchange();
  }
  made_.clear();
}

void OutputFolder::exchange() {
  // After the exchange the hidden name is the old folder; the destructor removes it.
  if (::renameat2(AT_FDCWD, hidden_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE) == 0)
    return;
  if (errno != EINVAL && errno != ENOSYS) throw_write_error(place_, errno);
  // The file system knows no exchange: two steps, the nearest to one.
  const fs::path old = hidden_.string() + "-old";
  if (::rename(place_.c_str(), old.c_str()) != 0) throw_write_error(place_, errno);
  if (::rename(hidden_.c_str(), place_.c_str()) != 0) {
    const int error = errno;
    ::rename(old.c_str(), place_.c_str());
    throw_write_error(place_, error);
  }
  hidden_ = old;
}

void check_output_folder(const fs::path& place, bool replace, const std::vector<fs::path>& inputs) {
  OutputFolder(place, replace, inputs);
}

}  // namespace regarment
