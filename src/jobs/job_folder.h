#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "jobs/job.h"

namespace regarment {

/// Where the files of jobs lie, below one folder DATA:
///   DATA/incoming/ID/   an upload not yet queued; sweep_data removes what a crash left there
///   DATA/incoming/delivery-ID-N/   what came so far of a result that a worker delivers by HTTP
///   DATA/jobs/ID/       scan.EXT     the scan as it was sent (ply, obj, off, stl, glb, gltf)
///                       truth.csv    the true dimensions, where given
///                       labels.u8    the true labels, where given
///                       scans/       of an evaluation: the scans of the table
///                       tables/      of an evaluation of a batch: what it compares
///                       result-N/    what the command wrote under the claim with token N; appears
///                                    whole, and counts once the job succeeded under this token
/// Ids that are none throw InvalidInput. Names come from us alone, but for the scans of an
/// evaluation, whose names a table knows: those hold letters, digits, dots, dashes and underscores.
class JobFolders {
 public:
  /// Makes DATA, readable to its owner only, and its two folders. Throws UsageError when it may not
  /// be written, TemporaryError when the disk is full.
  explicit JobFolders(std::filesystem::path data);

  const std::filesystem::path& data() const { return data_; }
  /// The file of the SQLite store where no other store is named.
  std::filesystem::path default_store() const;
  std::filesystem::path incoming(std::string_view id) const;
  std::filesystem::path job(std::string_view id) const;
  /// The result of a job that succeeded. What other result folders there are does not count.
  std::filesystem::path result(const Job& job) const;
  std::filesystem::path result(std::string_view id, std::int64_t token) const;
  /// Where the result of a claim arrives before it is whole.
  std::filesystem::path delivery(std::string_view id, std::int64_t token) const;
  /// Job and token of a folder named as `delivery` names them; nothing for other names.
  static std::optional<std::pair<std::string, std::int64_t>> claim_of_delivery(
      std::string_view name);
  /// The one file scan.* of a job. Throws ReadError when there is none.
  std::filesystem::path scan(std::string_view id) const;

  /// Makes the folder for an upload. Throws as the constructor does.
  std::filesystem::path begin_upload(std::string_view id) const;
  /// Moves an upload among the jobs, in one step; call it just before JobStore::create.
  void accept_upload(std::string_view id) const;
  /// Removes whatever there is of a job, in one step first, so that no reader finds half of it.
  void remove(std::string_view id) const;
  /// Removes results, whole or half, of all claims of a job but the one with token `keep`.
  void remove_leftovers(std::string_view id, std::int64_t keep) const;
  /// Bytes of all files of a job; 0 when it has none.
  std::uint64_t bytes(std::string_view id) const;
  /// Bytes free for us on the disk of DATA.
  std::uint64_t free_bytes() const;

 private:
  std::filesystem::path data_;
};

}  // namespace regarment
