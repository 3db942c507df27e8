#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace regarment {

/// One scan of a batch, ready to be fitted anywhere the files can be reached.
struct BatchScan {
  std::string name;                // of its result's folder
  std::filesystem::path file;      // absolute
  std::string sha256;              // of the file's bytes; empty: it could not be read
  std::string key;                 // 64 digits: changes with whatever changes the result
  std::vector<std::string> words;  // after `fit`, without --out
};

/// A batch as it was planned: what is fitted, how, and in which shards. Holds nothing of who does
/// the work or where the results go, so every engine writes the same bytes.
struct Manifest {
  std::string version, program_sha256;  // of the program that planned it and must run it
  std::filesystem::path table;          // absolute
  std::string table_sha256;
  std::filesystem::path scans_folder;  // another one to find scans in, absolute; empty: none
  std::string only;                    // pattern of scans' names; empty: all
  std::vector<std::string> options;    // given to every fit
  int timeout = 1800;                  // of each fit, s
  std::size_t shard_size = 1;          // scans in a shard, >= 1; the last may have fewer
  std::vector<BatchScan> scans;        // in the table's order, at least one

  std::size_t shards() const { return (scans.size() + shard_size - 1) / shard_size; }
  /// The scans of a shard: indices from first to before second.
  std::pair<std::size_t, std::size_t> shard(std::size_t index) const;
};

/// As JSON, by format regarment.batch/1. Throws UsageError naming a path that is no UTF-8.
std::string manifest_json(const Manifest& manifest);

/// Reads it back. Throws ReadError when it is none, or not one `manifest_json` writes.
Manifest parse_manifest(const std::string& json, const std::string& name_for_messages);

}  // namespace regarment
