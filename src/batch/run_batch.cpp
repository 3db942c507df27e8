#include "batch/run_batch.h"

#include <map>
#include <numeric>

#include "base/error.h"
#include "base/stopwatch.h"
#include "batch/batch_plan.h"
#include "batch/run_scans.h"
#include "report/text.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

// What a folder's last plan says of its scans, by name.
std::map<std::string, std::string> keys_of_before(const BatchFolder& folder) {
  std::map<std::string, std::string> out;
  try {
    for (const BatchScan& scan : folder.manifest().scans) out[scan.name] = scan.key;
  } catch (const ReadError&) {
    // There is none, or none that can be read: nothing of it is kept.
  }
  return out;
}

// Tells how far the fits are.
class Told {
 public:
  Told(const Progress& progress, std::size_t scans) : progress_(progress), scans_(scans) {}

  void tell() const { progress_.report("fit", share(), line_); }

  void kept() { ++done_; }

  void add(const ScanStatus& status) {
    ++done_, ++fresh_;
    if (status.failure) ++bad_;
    line_ = "scan " + std::to_string(done_) + " of " + std::to_string(scans_);
    if (bad_ > 0) line_ += ", " + std::to_string(bad_) + " without a result";
    if (done_ < scans_) {
      const double each = watch_.total() / static_cast<double>(fresh_);
      line_ += ", " + duration_text(each * static_cast<double>(scans_ - done_)) + " left";
    }
    tell();
  }

 private:
  double share() const {
    return scans_ == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(scans_);
  }

  const Progress& progress_;
  std::size_t scans_, done_ = 0, fresh_ = 0, bad_ = 0;
  Stopwatch watch_;
  std::string line_;
};

void run(const BatchFolder& folder, const Manifest& manifest, const std::vector<std::size_t>& scans,
         const RunScansOptions& options, const Progress& progress) {
  check_unchanged(manifest, options.program);
  Told told(progress, scans.size());
  std::vector<std::size_t> left;
  for (const std::size_t i : scans) {
    if (folder.status(manifest.scans[i])) {
      told.kept();
    } else {
      left.push_back(i);
    }
  }
  run_scans(
      folder, manifest, left, options,
      {[&](std::size_t, const ScanStatus& status) { told.add(status); }, [&] { told.tell(); }});
  told.tell();
}

}  // namespace

BatchFolder prepare_batch(const fs::path& place, const Manifest& manifest, bool retry) {
  const std::string json = manifest_json(manifest);
  BatchFolder folder = BatchFolder::create(place);
  const BatchLock lock = BatchLock::whole(folder);
  const auto before = keys_of_before(folder);
  bool stands = before.size() == manifest.scans.size();
  for (const BatchScan& scan : manifest.scans) {
    const auto known = before.find(scan.name);
    const bool same = known != before.end() && known->second == scan.key;
    const auto status = folder.status(scan);
    const bool again = retry && (!status || status->failure);
    if (!same || again) folder.forget(scan.name);
    stands = stands && same && !again && status;
  }
  if (!stands) folder.forget_merge();
  folder.write_manifest(json);
  return folder;
}

void run_all(const BatchFolder& folder, const Manifest& manifest, const fs::path& program,
             int workers, const Progress& progress) {
  const BatchLock lock = BatchLock::whole(folder);
  std::vector<std::size_t> all(manifest.scans.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  run(folder, manifest, all, {program, workers}, progress);
}

void run_shard(const BatchFolder& folder, const Manifest& manifest, std::size_t shard,
               const fs::path& program, const Progress& progress) {
  const auto [first, end] = manifest.shard(shard);
  const BatchLock lock = BatchLock::shard(folder, shard);
  std::vector<std::size_t> scans(end - first);
  std::iota(scans.begin(), scans.end(), first);
  run(folder, manifest, scans, {program, 1}, progress);
}

}  // namespace regarment
