#pragma once

#include <string>
#include <vector>

#include "batch/manifest.h"

namespace regarment {

/// A plan of scans of these names in shards of two; the scan of each is a file that need not exist.
inline Manifest plan_of(const std::vector<std::string>& names) {
  Manifest out;
  out.version = "1.2.3";
  out.program_sha256 = std::string(64, 'a');
  out.table = "/data/table.csv";
  out.table_sha256 = std::string(64, 'b');
  out.options = {"--method", "direct"};
  out.timeout = 60;
  out.shard_size = 2;
  for (const std::string& name : names) {
    out.scans.push_back({name,
                         "/data/" + name + ".ply",
                         std::string(64, 'c'),
                         "key of " + name,
                         {"/data/" + name + ".ply", "--garment", "skirt"}});
  }
  return out;
}

}  // namespace regarment
