#include "service/submit.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/one_line.h"
#include "jobs/job_command.h"
#include "report/files.h"
#include "service/job_json.h"
#include "service/truth_table.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMega = 1'000'000;
constexpr std::uint64_t kMostTable = 16 * kMega, kMostLabels = 20 * kMega;
constexpr std::size_t kLongestKey = 255, kLongestName = 255;
constexpr const char* kScan = "scan";
constexpr const char* kTruth = "ground_truth";
constexpr const char* kLabels = "labels";

std::string idempotency_key(const Request& request) {
  std::string key(request.headers.get("Idempotency-Key"));
  if (key.size() > kLongestKey)
    throw HttpProblem(400, "bad_parameter", "Idempotency-Key: more than 255 characters");
  return key;
}

std::string options_or_none(const std::string& text) { return text.empty() ? "{}" : text; }

void check_names(const Upload& upload, const std::vector<std::string>& known) {
  for (const std::string& name : upload.part_names())
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw HttpProblem(400, "bad_part",
                        "'" + one_line(name, 60) +
                            "' is no part of a job; send scan, garments, options, ground_truth, "
                            "labels, name, batch or kind");
}

JobKind kind_of(const Upload& upload) {
  const std::string kind = upload.text("kind");
  if (kind.empty() || kind == name_of(JobKind::Fit)) return JobKind::Fit;
  if (kind == name_of(JobKind::Render)) return JobKind::Render;
  throw HttpProblem(422, "bad_kind", "kind: give fit or render");
}

void check_batch(const Service& service, const Caller& caller, const std::string& batch) {
  if (batch.empty()) return;
  const std::optional<Batch> found = service.store.find_batch(batch);
  if (!found || (found->owner != caller.key.id && !caller.may(Scope::Admin)))
    throw HttpProblem(422, "no_such_batch", "batch: there is none of this id; POST /v1/batches");
}

// What the sender calls the scan, as text for people and for the table of truth.
std::string scan_name(const Upload& upload) {
  std::string name = upload.text("name");
  if (name.empty()) name = fs::path(upload.filename(kScan)).filename().string();
  return one_line(name, kLongestName);
}

void place_truth(const Upload& upload, const std::string& scan) {
  if (upload.has(kLabels)) fs::rename(upload.file(kLabels), upload.folder() / "labels.u8");
  if (!upload.has(kTruth)) return;
  const std::string table = read_file(upload.file(kTruth), kMostTable);
  write_file(upload.folder() / "truth.csv", truth_of_scan(table, upload.filename(kScan), scan));
  fs::remove(upload.file(kTruth));
}

// The name the scan has in its folder now.
std::string placed_name(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().stem() == kScan && entry.path().extension() != ".part")
      return entry.path().filename().string();
  return {};
}

Response submit(const Service& service, const Call& call, Upload& upload) {
  check_names(upload, {kScan, "garments", "options", kTruth, kLabels, "name", "batch", "kind"});
  if (!upload.has(kScan))
    throw HttpProblem(422, "no_scan", "scan: missing; send the file as the part 'scan'");
  NewJob job;
  job.kind = kind_of(upload);
  job.options = options_or_none(upload.text("options"));
  if (job.kind == JobKind::Fit) job.garments = read_garments(upload.text("garments"));
  check_options(service, job.kind, job.garments, job.options);
  job.batch = upload.text("batch");
  check_batch(service, call.caller, job.batch);
  job.name = scan_name(upload);
  job.owner = call.caller.key.id;
  place_scan(upload, kScan, upload.folder() / kScan);
  // The table names the scan as its fit does.
  const std::string told = scan_name_of(job.name);
  place_truth(upload, told.empty() ? placed_name(upload.folder()) : told);
  return queue_job(service, std::move(job), upload, call.request);
}

// Scans keep their names, by which the table knows them, when these are plain.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name.size() <= 100 && name[0] != '.' &&
         name.find_first_not_of(
             "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz._-") ==
             std::string::npos;
}

}  // namespace

std::unique_ptr<Exchange> begin_job(const Service& service, const Call& call) {
  check_room(service, call.caller.key.id);
  const std::uint64_t most = service.config.max_upload_mb * kMega;
  const std::map<std::string, std::uint64_t> files = {
      {kScan, most}, {kTruth, kMostTable}, {kLabels, kMostLabels}};
  auto upload =
      std::make_unique<Upload>(service.folders, files, !idempotency_key(call.request).empty());
  return begin_upload(
      call, std::move(upload), kScan, most,
      [&service](const Call& now, Upload& got) { return submit(service, now, got); });
}

Response submit_refit(const Service& service, const Call& call) {
  const Job source = find_job(service, call.captured.at(0));
  if (!call.caller.may_change(source) && !call.caller.may(Scope::Review))
    throw HttpProblem(403, "not_yours", "this key may not fit this job again");
  if (source.state != JobState::Succeeded ||
      (source.kind != JobKind::Fit && source.kind != JobKind::Refit))
    throw HttpProblem(409, "no_result", "only the result of a fit can be fitted again");
  check_room(service, call.caller.key.id);
  const nlohmann::json body = nlohmann::json::parse(call.body, nullptr, false);
  if (!body.is_object() || !body.contains("options") || !body["options"].is_object())
    throw HttpProblem(400, "bad_json", "the body must be {\"options\": {...}}");
  NewJob job;
  job.kind = JobKind::Refit;
  job.source = source.id;
  job.garments = source.garments;
  job.options = body["options"].dump();
  job.batch = source.batch;
  job.name = source.name;
  job.owner = call.caller.key.id;
  check_options(service, job.kind, job.garments, job.options);
  Upload upload(service.folders, {}, !idempotency_key(call.request).empty());
  upload.add_text("refit", source.id + job.options);
  return queue_job(service, std::move(job), upload, call.request);
}

Response queue_job(const Service& service, NewJob job, Upload& upload, const Request& request) {
  job.id = upload.id();
  job.idempotency_key = idempotency_key(request);
  job.body_sha256 = upload.hash();
  upload.accept();
  job.bytes = service.folders.bytes(job.id);
  const Created created = service.store.create(job);
  if (created.kind == Created::Kind::KeyClash)
    throw HttpProblem(422, "key_used",
                      "this Idempotency-Key stands for another request; use a new one");
  if (created.kind == Created::Kind::Made) upload.keep();
  Response out = text_response(202, "application/json", job_json(created.job, {}));
  out.headers = {{"Location", "/v1/jobs/" + created.job.id}, {"Retry-After", "1"}};
  return out;
}

std::unique_ptr<Exchange> begin_evaluation(const Service& service, const Call& call) {
  check_room(service, call.caller.key.id);
  const std::uint64_t most = service.config.max_upload_mb * kMega;
  auto upload = std::make_unique<Upload>(
      service.folders, std::map<std::string, std::uint64_t>{{"table", kMostTable}},
      !idempotency_key(call.request).empty());
  upload->take_other_files(most);
  const auto answer = [&service](const Call& now, Upload& got) {
    if (!got.has("table"))
      throw HttpProblem(422, "no_table", "table: missing; send the CSV table as the part 'table'");
    fs::create_directory(got.folder() / "scans");
    for (const std::string& part : got.part_names()) {
      const std::string name = got.filename(part);
      if (part == "table" || part == "options" || part == "name") continue;
      if (!is_plain_name(name))
        throw HttpProblem(422, "bad_name",
                          "a scan of an evaluation needs a file name of letters, digits, dots, "
                          "dashes and underscores, as the table has it");
      fs::rename(got.file(part), got.folder() / "scans" / name);
    }
    fs::rename(got.file("table"), got.folder() / "truth.csv");
    NewJob job;
    job.kind = JobKind::Evaluate;
    job.name = one_line(got.text("name"), kLongestName);
    job.options = options_or_none(got.text("options"));
    job.owner = now.caller.key.id;
    check_options(service, job.kind, {}, job.options);
    return queue_job(service, std::move(job), got, now.request);
  };
  return begin_upload(call, std::move(upload), "table", most, answer);
}

}  // namespace regarment
