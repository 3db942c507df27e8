#include "jobs/job_folder.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>

#include "base/error.h"
#include "base/one_line.h"
#include "report/files.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDelivery = "delivery-";
constexpr std::array kScanEndings = {"ply", "obj", "off", "stl", "glb", "gltf"};

// Scans are personal: nobody but the service reads them.
void make_folder(const fs::path& folder) {
  if (::mkdir(folder.c_str(), 0700) == 0) return;
  const int why = errno;
  std::error_code ignored;
  if (why != EEXIST || !fs::is_directory(folder, ignored)) throw_write_error(folder, why);
}

// Only names of the form we give become part of a path.
std::string checked(std::string_view id) {
  if (!is_job_id(id)) throw InvalidInput("'" + one_line(id, 60) + "' is no job id");
  return std::string(id);
}

}  // namespace

JobFolders::JobFolders(fs::path data) : data_(std::move(data)) {
  if (data_.empty()) throw UsageError("--data: the value is empty; give a folder");
  std::error_code error;
  data_ = fs::absolute(data_, error).lexically_normal();
  if (!data_.has_filename()) data_ = data_.parent_path();
  fs::create_directories(data_.parent_path(), error);
  if (error) throw_write_error(data_.parent_path(), error.value());
  make_folder(data_);
  make_folder(data_ / "incoming");
  make_folder(data_ / "jobs");
}

fs::path JobFolders::default_store() const { return data_ / "store.sqlite3"; }

fs::path JobFolders::incoming(std::string_view id) const {
  return data_ / "incoming" / checked(id);
}

fs::path JobFolders::job(std::string_view id) const { return data_ / "jobs" / checked(id); }

fs::path JobFolders::result(const Job& job) const { return result(job.id, job.token); }

fs::path JobFolders::result(std::string_view id, std::int64_t token) const {
  return this->job(id) / ("result-" + std::to_string(token));
}

fs::path JobFolders::delivery(std::string_view id, std::int64_t token) const {
  return data_ / "incoming" / (std::string(kDelivery) + checked(id) + "-" + std::to_string(token));
}

fs::path JobFolders::scan(std::string_view id) const {
  for (const char* ending : kScanEndings) {
    fs::path file = job(id) / ("scan." + std::string(ending));
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) return file;
  }
  throw ReadError("job " + checked(id) + " has no scan in its folder; send the scan again");
}

std::optional<std::pair<std::string, std::int64_t>> JobFolders::claim_of_delivery(
    std::string_view name) {
  if (!name.starts_with(kDelivery)) return std::nullopt;
  name.remove_prefix(kDelivery.size());
  const std::size_t dash = std::min(name.find('-'), name.size());
  const std::string_view id = name.substr(0, dash),
                         number = name.substr(std::min(dash + 1, name.size()));
  std::int64_t token = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), token);
  if (!is_job_id(id) || error != std::errc() || end != number.data() + number.size())
    return std::nullopt;
  return std::pair(std::string(id), token);
}

fs::path JobFolders::begin_upload(std::string_view id) const {
  fs::path folder = incoming(id);
  make_folder(folder);
  return folder;
}

void JobFolders::accept_upload(std::string_view id) const {
  std::error_code error;
  fs::rename(incoming(id), job(id), error);
  if (error) throw_write_error(job(id), error.value());
}

void JobFolders::remove(std::string_view id) const {
  std::error_code ignored;
  const fs::path gone = data_ / "incoming" / ("removed-" + new_job_id());
  fs::rename(job(id), gone, ignored);
  fs::remove_all(gone, ignored);
  fs::remove_all(incoming(id), ignored);
}

void JobFolders::remove_leftovers(std::string_view id, std::int64_t keep) const {
  std::error_code ignored;
  const std::string kept = result(id, keep).filename().string();
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(job(id), ignored)) {
    const std::string name = entry.path().filename().string();
    // An output folder under way is hidden beside its place.
    if (name != kept && (name.starts_with("result-") || name.starts_with("."))) {
      left.push_back(entry.path());
    }
  }
  for (const fs::path& one : left) fs::remove_all(one, ignored);
}

std::uint64_t JobFolders::bytes(std::string_view id) const {
  std::uint64_t sum = 0;
  std::error_code ignored;
  fs::recursive_directory_iterator entry(job(id), ignored), end;
  for (; entry != end; entry.increment(ignored)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone)) continue;
    const auto size = entry->file_size(gone);
    if (!gone) sum += size;
  }
  return sum;
}

std::uint64_t JobFolders::free_bytes() const {
  std::error_code error;
  const fs::space_info space = fs::space(data_, error);
  return error ? 0 : space.available;
}

}  // namespace regarment
