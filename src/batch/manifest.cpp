#include "batch/manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "regarment.batch/1";
constexpr int kLongestTimeout = 1'000'000;  // s

Json scan_json(const BatchScan& scan) {
  return {{"name", scan.name},
          {"file", scan.file.string()},
          {"sha256", scan.sha256},
          {"key", scan.key},
          {"fit", scan.words}};
}

Json shards_json(const Manifest& manifest) {
  Json out = Json::array();
  for (std::size_t i = 0; i < manifest.shards(); ++i) {
    const auto [first, end] = manifest.shard(i);
    out.push_back({{"first", first}, {"scans", end - first}});
  }
  return out;
}

// A folder's name, and nothing that leads out of the folder it is in.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name.front() != '.' && name.find('/') == std::string::npos &&
         name.find('\0') == std::string::npos;
}

BatchScan parse_scan(const Json& json) {
  BatchScan out;
  out.name = json.at("name").get<std::string>();
  out.file = json.at("file").get<std::string>();
  out.sha256 = json.at("sha256").get<std::string>();
  out.key = json.at("key").get<std::string>();
  out.words = json.at("fit").get<std::vector<std::string>>();
  if (!is_plain_name(out.name)) throw ReadError("'" + one_line(out.name, 60) + "' is no name");
  return out;
}

Manifest parse(const Json& json) {
  if (json.at("format") != kFormat) throw ReadError(std::string("its format is not ") + kFormat);
  Manifest out;
  out.version = json.at("program").at("version").get<std::string>();
  out.program_sha256 = json.at("program").at("sha256").get<std::string>();
  out.table = json.at("table").at("file").get<std::string>();
  out.table_sha256 = json.at("table").at("sha256").get<std::string>();
  out.scans_folder = json.at("scans_folder").get<std::string>();
  out.only = json.at("only").get<std::string>();
  out.options = json.at("options").get<std::vector<std::string>>();
  out.timeout = json.at("timeout_s").get<int>();
  out.shard_size = json.at("shard_size").get<std::size_t>();
  for (const Json& scan : json.at("scans")) out.scans.push_back(parse_scan(scan));
  const bool sound = !out.scans.empty() && out.shard_size >= 1 && out.timeout >= 1 &&
                     out.timeout <= kLongestTimeout;
  if (!sound) throw ReadError("its scans, shard_size or timeout_s are out of range");
  return out;
}

}  // namespace

std::pair<std::size_t, std::size_t> Manifest::shard(std::size_t index) const {
  if (index >= shards()) {
    throw UsageError("shard " + std::to_string(index) + ": the batch has shards 0 to " +
                     std::to_string(shards() - 1));
  }
  return {index * shard_size, std::min(scans.size(), (index + 1) * shard_size)};
}

std::string manifest_json(const Manifest& manifest) {
  Json scans = Json::array();
  for (const BatchScan& scan : manifest.scans) scans.push_back(scan_json(scan));
  const Json json = {
      {"format", kFormat},
      {"program", {{"version", manifest.version}, {"sha256", manifest.program_sha256}}},
      {"table", {{"file", manifest.table.string()}, {"sha256", manifest.table_sha256}}},
      {"scans_folder", manifest.scans_folder.string()},
      {"only", manifest.only},
      {"options", manifest.options},
      {"timeout_s", manifest.timeout},
      {"shard_size", manifest.shard_size},
      {"shards", shards_json(manifest)},
      {"scans", scans}};
  try {
    return json.dump(1) + "\n";
  } catch (const Json::exception&) {
    throw UsageError(one_line(manifest.table.string(), 200) +
                     ": a path or option of the batch is no UTF-8; rename it");
  }
}

Manifest parse_manifest(const std::string& json, const std::string& name) {
  const std::string cure = "; run 'regarment batch' again";
  try {
    return parse(Json::parse(json));
  } catch (const ReadError& error) {
    throw ReadError(name + ": " + error.what() + cure);
  } catch (const Json::exception& error) {
    throw ReadError(name + ": is no manifest of a batch (" + one_line(error.what(), 200) + ")" +
                    cure);
  }
}

}  // namespace regarment
