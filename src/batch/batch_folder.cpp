#include "batch/batch_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "base/error.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.json";
constexpr const char* kLock = ".lock";
// What the merge writes, the last first.
constexpr std::array kMerge{"evaluation.json", "evaluation.html", "evaluation.csv",
                            "measurements.csv"};
constexpr std::size_t kMostManifestBytes = std::size_t{256} << 20U;
constexpr std::size_t kMostStatusBytes = 64U << 10U;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = {ENOTDIR, std::generic_category()};
  if (error) throw_write_error(folder, error.value());
}

fs::path status_file(const fs::path& place, const std::string& name) {
  return place / "status" / (name + ".json");
}

// Locks bytes of a file for as long as it is open here; false when somebody else has some of them.
bool lock_bytes(int file, off_t first, off_t count) {
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = first;
  range.l_len = count;
  return ::fcntl(file, F_OFD_SETLK, &range) == 0;
}

}  // namespace

BatchFolder::BatchFolder(const fs::path& place) : place_(fs::absolute(place)) {
  std::error_code error;
  if (!fs::is_regular_file(place_ / kManifest, error)) {
    throw ReadError(place.string() + ": holds no " + kManifest +
                    "; give the folder of a 'regarment batch'");
  }
}

BatchFolder BatchFolder::create(const fs::path& place) {
  BatchFolder out;
  out.place_ = fs::absolute(place);
  make_folder(out.place_);
  std::error_code error;
  const bool ours = fs::is_empty(out.place_, error) || fs::exists(out.place_ / kManifest, error) ||
                    fs::exists(out.place_ / kLock, error);
  if (!ours) {
    throw UsageError(place.string() + ": is not empty and holds no batch; choose another --out");
  }
  for (const char* name : {"fits", "status", "attempts"}) make_folder(out.place_ / name);
  return out;
}

Manifest BatchFolder::manifest() const {
  const fs::path file = place_ / kManifest;
  return parse_manifest(read_file(file, kMostManifestBytes), file.string());
}

void BatchFolder::write_manifest(const std::string& json) const {
  try {
    if (read_file(place_ / kManifest, json.size() + 1) == json) return;
  } catch (const ReadError&) {
    // There is none yet.
  }
  write(kManifest, json);
}

std::optional<ScanStatus> BatchFolder::status(const BatchScan& scan) const {
  try {
    auto out = parse_status(read_file(status_file(place_, scan.name), kMostStatusBytes));
    if (!out || out->key != scan.key || out->name != scan.name) return std::nullopt;
    if (!out->failure && out->result_sha256 != result_sha256(scan.name)) return std::nullopt;
    return out;
  } catch (const ReadError&) {
    return std::nullopt;
  }
}

void BatchFolder::write_status(const ScanStatus& status) const {
  replace_file(status_file(place_, status.name), status_json(status));
  std::error_code ignored;
  fs::remove(place_ / "attempts" / status.name, ignored);
}

void BatchFolder::forget(const std::string& name) const {
  std::error_code ignored;
  fs::remove(status_file(place_, name), ignored);
  fs::remove(place_ / "attempts" / name, ignored);
}

int BatchFolder::attempts(const std::string& name) const {
  std::error_code error;
  const auto size = fs::file_size(place_ / "attempts" / name, error);
  return error ? 0 : static_cast<int>(size);
}

void BatchFolder::begin_attempt(const std::string& name) const {
  const fs::path file = place_ / "attempts" / name;
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (opened < 0) throw_write_error(file, errno);
  const bool written = ::write(opened, "x", 1) == 1;
  const int error = errno;
  ::close(opened);
  if (!written) throw_write_error(file, error);
}

void BatchFolder::give_back_attempt(const std::string& name) const {
  const fs::path file = place_ / "attempts" / name;
  const int left = attempts(name) - 1;
  std::error_code ignored;
  if (left > 0) {
    fs::resize_file(file, static_cast<std::uintmax_t>(left), ignored);
  } else {
    fs::remove(file, ignored);
  }
}

bool BatchFolder::is_merged() const {
  std::error_code ignored;
  return fs::is_regular_file(place_ / kMerge[0], ignored);
}

void BatchFolder::forget_merge() const {
  for (const char* name : kMerge) {
    std::error_code ignored;
    fs::remove(place_ / name, ignored);
  }
}

void BatchFolder::write(const std::string& name, std::string_view bytes) const {
  replace_file(place_ / name, bytes);
}

std::string BatchFolder::result_sha256(const std::string& name) const {
  return file_sha256(fit(name) / "result.json");
}

BatchLock BatchLock::take(const BatchFolder& folder, long first, long count,
                          const std::string& what) {
  BatchLock out;
  const fs::path file = folder.place() / kLock;
  out.file_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (out.file_ < 0) throw_write_error(file, errno);
  if (lock_bytes(out.file_, first, count)) return out;
  if (errno != EAGAIN && errno != EACCES) throw_write_error(file, errno);
  throw TemporaryError(folder.place().string() + ": " + what +
                       " is being worked on by another process; wait for it");
}

BatchLock BatchLock::whole(const BatchFolder& folder) { return take(folder, 0, 0, "the batch"); }

BatchLock BatchLock::shard(const BatchFolder& folder, std::size_t index) {
  return take(folder, static_cast<long>(index), 1, "shard " + std::to_string(index));
}

BatchLock::BatchLock(BatchLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

BatchLock::~BatchLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace regarment
