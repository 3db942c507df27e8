#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "batch/manifest.h"
#include "batch/scan_status.h"

namespace regarment {

/// The folder of a batch:
///   manifest.json    the plan
///   fits/NAME/       the result of each scan
///   status/NAME.json what became of it; written once its result stands
///   attempts/NAME    one byte for each try that has begun and not ended; gone once it has ended
///   evaluation.*     the merge, and measurements.csv
///   .lock            see BatchLock
/// Every file appears whole or not at all. Any number of processes may have one open.
class BatchFolder {
 public:
  /// A folder that `create` made. Throws ReadError when `place` holds no batch.
  explicit BatchFolder(const std::filesystem::path& place);

  /// Makes the folder, or takes an empty one or one that holds a batch. Throws UsageError when
  /// something else stands there or it is not writable, TemporaryError when the disk is full.
  static BatchFolder create(const std::filesystem::path& place);

  const std::filesystem::path& place() const { return place_; }  // absolute
  std::filesystem::path fit(const std::string& name) const { return place_ / "fits" / name; }

  /// Throws ReadError when it is not there or is none.
  Manifest manifest() const;
  /// Leaves a manifest of the same bytes alone.
  void write_manifest(const std::string& json) const;

  /// What is known of a scan; nothing where it is of another key, or its result is not the one
  /// that was finished.
  std::optional<ScanStatus> status(const BatchScan& scan) const;
  /// Writes it, and forgets the attempts.
  void write_status(const ScanStatus& status) const;
  /// Forgets the status of a scan and its attempts.
  void forget(const std::string& name) const;

  /// Tries that have begun and not ended.
  int attempts(const std::string& name) const;
  void begin_attempt(const std::string& name) const;
  /// One try less: it was no fault of the scan that it ended.
  void give_back_attempt(const std::string& name) const;

  /// Whether the merge stands, and taking it away: it is of another plan.
  bool is_merged() const;
  void forget_merge() const;

  /// Writes a file of this name in one step.
  void write(const std::string& name, std::string_view bytes) const;
  /// SHA-256 of the result.json of a scan; empty when there is none.
  std::string result_sha256(const std::string& name) const;

 private:
  BatchFolder() = default;

  std::filesystem::path place_;
};

/// Who works in the folder of a batch. The file system frees it when its holder ends, however.
class BatchLock {
 public:
  /// All of it, or one shard beside others. Throws TemporaryError when somebody else is at work
  /// on it.
  static BatchLock whole(const BatchFolder& folder);
  static BatchLock shard(const BatchFolder& folder, std::size_t index);
  ~BatchLock();
  BatchLock(BatchLock&& other) noexcept;
  BatchLock(const BatchLock&) = delete;
  BatchLock& operator=(const BatchLock&) = delete;
  BatchLock& operator=(BatchLock&&) = delete;

 private:
  BatchLock() = default;
  static BatchLock take(const BatchFolder& folder, long first, long count, const std::string& what);

  int file_ = -1;
};

}  // namespace regarment
