#include "app/prepared_scan.h"

#include <optional>
#include <span>
#include <utility>

#include "analysis/scan_state.h"
#include "base/error.h"
#include "base/sha256.h"
#include "scan/file_bytes.h"
#include "scan/make_scan.h"
#include "scan/read_sandboxed.h"

namespace regarment {
namespace {

// Made from everything that what is prepared depends on.
std::string entry_name(const FitArguments& a, const std::string& sha256) {
  std::string all = "prepared\n" + build_identity();
  for (const std::string& part : {sha256, a.units, a.up, a.front, name_of_scan(a)})
    all += "\n" + part;
  return sha256_hex(std::as_bytes(std::span(all)));
}

// Nothing for an entry that is not there or broken.
std::optional<PreparedScan> taken(const StageCache& cache, const std::string& name) {
  std::optional<std::string> bytes = cache.get(name);
  if (!bytes) return std::nullopt;
  try {
    Scan scan = read_state(*bytes, "the prepared scan").scan;
    return PreparedScan{std::move(scan), std::move(*bytes)};
  } catch (const ReadError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string name_of_scan(const FitArguments& a) {
  return a.name.empty() ? a.scan.filename().string() : a.name;
}

PreparedScan prepared_scan(const FitArguments& a, const StageCache* cache, const Progress& progress,
                           const std::function<void(const char* stage)>& lap) {
  const bool known = cache != nullptr && !build_identity().empty();
  if (known) {
    progress.report("read", 0.0);
    const FileBytes file = read_file_bytes(a.scan, ReadLimits().file_bytes);
    if (auto found = taken(*cache, entry_name(a, sha256_hex(file.span())))) {
      lap("read");
      return std::move(*found);
    }
  }
  ReadMesh read = read_mesh_sandboxed(a.scan, {}, progress);
  lap("read");
  progress.report("prepare", 0.0);
  ScanState state;
  state.scan = make_scan(std::move(read.mesh), {a.units, a.up, a.front});
  state.scan.facts.file = name_of_scan(a);
  state.scan.facts.sha256 = read.sha256;
  PreparedScan out;
  out.stored = write_state(state);
  if (known) cache->put(entry_name(a, read.sha256), out.stored);
  out.scan = read_state(out.stored, "the prepared scan").scan;
  progress.report("prepare", 1.0);
  lap("prepare");
  return out;
}

}  // namespace regarment
