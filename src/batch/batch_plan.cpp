#include "batch/batch_plan.h"

#include <algorithm>
#include <span>

#include "base/error.h"
#include "base/sha256.h"
#include "evaluation/evaluation_table.h"
#include "evaluation/fit_job.h"
#include "evaluation/gate.h"
#include "evaluation/sum_up.h"
#include "report/files.h"
#include "report/version.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostTableBytes = (16U << 20U) + 1;  // CsvTable refuses more
constexpr std::size_t kMostShards = 1000;                  // Slurm's own limit, unless raised

std::string text_sha256(const std::string& text) {
  return sha256_hex(std::as_bytes(std::span(text.data(), text.size())));
}

std::vector<EvaluationCase> read_cases(const std::string& text, const Manifest& manifest) {
  const CsvTable table = CsvTable::parse(text, manifest.table.filename().string());
  const std::optional<fs::path> scans =
      manifest.scans_folder.empty() ? std::nullopt : std::optional(manifest.scans_folder);
  return read_campaign_table(table, manifest.table.parent_path(), scans, manifest.only);
}

[[noreturn]] void throw_changed(const std::string& what) {
  throw UsageError(what + " is not what the batch was planned with; run 'regarment batch' again");
}

void check_gates(const std::vector<std::string>& texts, const std::vector<EvaluationCase>& cases) {
  std::vector<Gate> gates;
  gates.reserve(texts.size());
  for (const std::string& text : texts) gates.push_back(parse_gate(text));
  check_gate_groups(gates, expected_groups(cases));
}

BatchScan batch_scan(const EvaluationCase& one, const FitJobOptions& how,
                     const std::string& program_sha256) {
  BatchScan out;
  out.name = one.name;
  out.file = one.scan;
  out.sha256 = file_sha256(one.scan);
  out.key = text_sha256(make_fit_job(one, how, program_sha256).key + "scan " + out.sha256 + "\n");
  out.words = fit_words(one, how);
  return out;
}

void check_fit(const BatchScan& scan, const EvaluationCase& one, const BatchOptions& options) {
  if (!options.check_fit) return;
  std::vector<std::string> command = {options.program.string(), "fit"};
  command.insert(command.end(), scan.words.begin(), scan.words.end());
  command.insert(command.end(), {"--out", "out"});
  try {
    options.check_fit(command, one.garments);
  } catch (const UsageError& error) {
    throw UsageError("the fit of " + one.name + ": " + error.what());
  }
}

}  // namespace

Manifest plan_batch(const BatchOptions& options, const Progress& progress) {
  Manifest out;
  out.version = version();
  out.program_sha256 = file_sha256(options.program);
  out.table = fs::absolute(options.table);
  if (options.scans) out.scans_folder = fs::absolute(*options.scans);
  out.only = options.only;
  out.options = options.fit_options;
  out.timeout = options.timeout;
  out.shard_size = options.shard_size;
  const std::string text = read_file(out.table, kMostTableBytes);
  out.table_sha256 = text_sha256(text);
  const std::vector<EvaluationCase> cases = read_cases(text, out);
  check_gates(options.gates, cases);
  // No times: who did the work and how fast must not show.
  const FitJobOptions how{options.program, out.table, "fits", options.fit_options, 1, false};
  for (const EvaluationCase& one : cases) {
    progress.report(
        "plan", static_cast<double>(out.scans.size()) / static_cast<double>(cases.size()),
        "scan " + std::to_string(out.scans.size() + 1) + " of " + std::to_string(cases.size()));
    out.scans.push_back(batch_scan(one, how, out.program_sha256));
    check_fit(out.scans.back(), one, options);
  }
  progress.report("plan", 1);
  if (out.shards() > kMostShards) {
    throw UsageError(std::to_string(out.shards()) + " shards are more than " +
                     std::to_string(kMostShards) + "; give a larger --shard-size");
  }
  return out;
}

std::vector<EvaluationCase> cases_of(const Manifest& manifest) {
  const std::string text = read_file(manifest.table, kMostTableBytes);
  if (text_sha256(text) != manifest.table_sha256) throw_changed(manifest.table.string());
  std::vector<EvaluationCase> cases = read_cases(text, manifest);
  const bool same = std::equal(cases.begin(), cases.end(), manifest.scans.begin(),
                               manifest.scans.end(), [](const auto& one, const auto& scan) {
                                 return one.name == scan.name && one.scan == scan.file;
                               });
  if (!same) throw_changed("what " + manifest.table.string() + " finds beside it");
  return cases;
}

void check_unchanged(const Manifest& manifest, const fs::path& program) {
  if (file_sha256(manifest.table) != manifest.table_sha256) throw_changed(manifest.table.string());
  if (file_sha256(program) != manifest.program_sha256) throw_changed(program.string());
}

}  // namespace regarment
